#pragma once

// What the option parser refuses, in words: what was expected, what stood there, what to do.

#include <CLI/CLI.hpp>
#include <string>

namespace cli {

// The parser's own text where it is of a kind that is not known here. `app` is as the parser left
// it.
std::string in_words(const CLI::App& app, const CLI::ParseError& error);

}  // namespace cli
