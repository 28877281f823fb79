#pragma once

// Options that only some formats use: given beside another format they are wrong usage, because
// whoever gave them believes that they count.

#include <CLI/CLI.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cli {

// A row of a tool's table.
struct FormatOption {
  const char* option;                     // "--where"
  std::vector<std::string_view> formats;  // that use it, by the tool's own words
  const char* with = nullptr;             // an option beside which every format uses it
};

// Throws UsageError where the command line has an option of the table that a file of this format
// does not use. `file` is its name for the message.
void require_used(const CLI::App& app, std::span<const FormatOption> table, std::string_view format,
                  const std::string& file);

}  // namespace cli
