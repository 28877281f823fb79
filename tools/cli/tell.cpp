#include "tell.h"

#include <fmt/format.h>
#include <unistd.h>

#include "cli/file/standard_streams.h"
#include "geom/text/counted.h"

namespace cli {

void tell(const Common& common, std::string_view tool, std::string_view message) {
  common.note(fmt::format("{}: {}\n", tool, shown_message(message)));
}

void tell_no(const Common& common, std::string_view tool, std::string_view message) {
  const std::string said = fmt::format("{}: {}", tool, shown_message(message));
  common.note(takes_colour(STDERR_FILENO) ? fmt::format("\x1b[31m{}\x1b[0m\n", said) : said + '\n');
}

void tell_left_out(const Common& common, std::string_view tool, std::size_t count) {
  if (count == 0) return;
  tell(common, tool,
       fmt::format("{} no path or trajectory",
                   geom::counted(count, "record holds", "records hold")));
}

geom::Notes notes_of(const Common& common, std::string tool) {
  return {[&common, tool](const std::string& text) { tell(common, tool, text); },
          [&common](const std::string& text) { common.warn(text); }};
}

}  // namespace cli
