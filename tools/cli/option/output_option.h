#pragma once

// Options that name outputs.

#include <CLI/CLI.hpp>
#include <string>

namespace cli {

class RunFiles;

// As App::add_option() does it, of a file that is written. "-" is stdout.
CLI::Option* add_output(CLI::App& app, const std::string& flags, std::string& file,
                        const std::string& description);

// Tells of all outputs that the parsed options name. Throws UsageError where two are one file.
void expect_outputs(RunFiles& files);

}  // namespace cli
