#pragma once

// What the option parser refuses, in words: what was expected, what stood there, what to do.

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>

namespace cli {

// What is wrong is told by the type of the error and by what the parser knows of each option; the
// error's own text stands only where both are not enough. `app` is as the parser left it, and
// `last_word` the last of the command line, whose value may be missing.
std::string in_words(CLI::App& app, const CLI::ParseError& error, std::string_view last_word);

}  // namespace cli
