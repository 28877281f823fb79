#pragma once

// What the option parser lets pass and nobody can mean.

#include <CLI/CLI.hpp>
#include <initializer_list>
#include <string_view>

namespace cli {

// Throws UsageError where a parsed option or argument is empty, or a number is not finite: "nan" is
// within every range.
void check_values(const CLI::App& app);

// Throws UsageError where one of the options was given and does not `apply`: an option that is not
// obeyed must not look as if it were. `to_what` in words: "--format setpoints".
void only_for(const CLI::App& app, bool apply, std::initializer_list<const char*> options,
              std::string_view to_what);

}  // namespace cli
