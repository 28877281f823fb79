#include "format_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "option_check.h"

namespace cli {

void require_used(const CLI::App& app, std::span<const FormatOption> table, std::string_view format,
                  const std::string& file) {
  for (const FormatOption& row : table) {
    const bool read =
        std::find(row.formats.begin(), row.formats.end(), format) != row.formats.end();
    const bool used = read || (row.with && app.get_option(row.with)->count() > 0);
    only_for(app, used, {row.option},
             fmt::format("{} files{}{} ({} is read as {})", fmt::join(row.formats, ", "),
                         row.with ? " or with " : "", row.with ? row.with : "", file, format));
  }
}

}  // namespace cli
