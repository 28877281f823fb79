#include "format_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "option_check.h"

namespace cli {

void require_used(const CLI::App& app, std::span<const FormatOption> table, std::string_view format,
                  std::string_view because) {
  require_used(app, table, std::span(&format, 1), because);
}

void require_used(const CLI::App& app, std::span<const FormatOption> table,
                  std::span<const std::string_view> formats, std::string_view because) {
  for (const FormatOption& row : table) {
    if (!app.get_option_no_throw(row.option)) continue;
    const bool read = std::find_first_of(row.formats.begin(), row.formats.end(), formats.begin(),
                                         formats.end()) != row.formats.end();
    std::string others;  // " or with --return"
    bool used = read;
    for (const char* with : row.with) {
      const CLI::Option* other = app.get_option_no_throw(with);
      if (!other) continue;
      others += fmt::format(" or with {}", with);
      used = used || other->count() > 0;
    }
    only_for(app, used, {row.option},
             fmt::format("{} files{} ({})", fmt::join(row.formats, ", "), others, because));
  }
}

std::string read_as(std::string_view file, std::string_view format) {
  return fmt::format("{} is read as {}", file, format);
}

}  // namespace cli
