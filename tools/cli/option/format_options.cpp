#include "format_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "option_check.h"

namespace cli {

void require_used(const CLI::App& app, std::span<const FormatOption> table, std::string_view format,
                  std::string_view because) {
  for (const FormatOption& row : table) {
    if (!app.get_option_no_throw(row.option)) continue;
    const bool read =
        std::find(row.formats.begin(), row.formats.end(), format) != row.formats.end();
    const CLI::Option* with = row.with ? app.get_option_no_throw(row.with) : nullptr;
    const bool used = read || (with && with->count() > 0);
    only_for(app, used, {row.option},
             fmt::format("{} files{}{} ({})", fmt::join(row.formats, ", "),
                         with ? " or with " : "", with ? row.with : "", because));
  }
}

std::string read_as(std::string_view file, std::string_view format) {
  return fmt::format("{} is read as {}", file, format);
}

}  // namespace cli
