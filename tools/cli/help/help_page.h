#pragma once

// The help texts: --help shows the options that are used most, --help-all shows all of them, and
// the hidden --help-man prints the section OPTIONS of the manual page.

#include <CLI/CLI.hpp>
#include <string>

namespace cli {

// For an app with all its options and verbs.
void add_help(CLI::App& app);

// The section OPTIONS in pandoc's Markdown, without its heading and after a blank line.
std::string manual_options(const CLI::App& app);

}  // namespace cli
