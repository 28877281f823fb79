#pragma once

// Completion scripts for bash and zsh, made from a tool's own option parser.

#include <CLI/CLI.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace cli {

enum class Shell { bash, zsh };

// A script that completes the tool's verbs, options, words that an option takes from a fixed set,
// and file names elsewhere. For bash it is sourced; for zsh it is a file `_NAME` in the fpath.
std::string completion(const CLI::App& app, Shell shell);

// The same for a front end that runs FRONT-VERB for its first argument: completes the verb, and
// leaves the rest to that tool.
std::string completion(const std::string& front,
                       std::span<const std::pair<const char*, const char*>> verbs, Shell shell);

// The hidden option `--completion bash|zsh`, which prints the script and ends the program.
void add_completion(CLI::App& app);

std::optional<Shell> shell_from(std::string_view word);

}  // namespace cli
