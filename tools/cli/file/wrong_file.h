#pragma once

// What to say of a file that is of another kind than its place takes.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace cli {

// What to say in place of an error whose source is `source` (geom::InputError), if that is an input
// of this run that recognise() knows and that its option or argument does not take: what was
// expected, what the file is, and what to do: swap two arguments, make what was expected, or use
// another tool. Nothing where the error says more: of damage in a file of the right kind. `app` is
// as the parser left it.
std::optional<std::string> wrong_file(const CLI::App& app, std::string_view source);

}  // namespace cli
