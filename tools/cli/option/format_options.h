#pragma once

// --format, and options that only some formats use: given beside another format they are wrong
// usage, because whoever gave them believes that they count.

#include <CLI/CLI.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geom/base/format.h"

namespace cli {

// Adds --format, which takes "auto" and the words of a table. `format` is null for auto.
template <class Row>
void add_format(CLI::App& app, geom::FormatRows<Row> table, const Row*& format) {
  std::vector<std::string> words = {"auto"};
  for (const std::string_view word : geom::words_of(table)) words.emplace_back(word);
  app.add_option_function<std::string>(
         "--format",
         [table, &format](const std::string& word) { format = geom::row_named(word, table); },
         "what the file is (default: auto)")
      ->check(CLI::IsMember(words));
}

// A row of a tool's table.
struct FormatOption {
  const char* option;                     // "--where"
  std::vector<std::string_view> formats;  // that use it, by the tool's own words
  std::vector<const char*> with = {};     // options beside any of which every format uses it
};

// Throws UsageError where the command line has an option of the table that this format does not
// use. `because` tells the format: "city.osm is read as osm". An option of the table that the tool
// does not have is passed over, so that tools may share a table.
void require_used(const CLI::App& app, std::span<const FormatOption> table, std::string_view format,
                  std::string_view because);

// The same for files of several formats: an option is used if one of them uses it.
void require_used(const CLI::App& app, std::span<const FormatOption> table,
                  std::span<const std::string_view> formats, std::string_view because);

// "city.osm is read as osm".
std::string read_as(std::string_view file, std::string_view format);

}  // namespace cli
