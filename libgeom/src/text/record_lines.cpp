#include "geom/text/record_lines.h"

#include "geom/base/error.h"

namespace geom {
namespace {

bool is_blank(const std::string& line) {
  return line.find_first_not_of(" \t\r") == std::string::npos;
}

}  // namespace

void for_each_line(std::istream& in, const std::string& source,
                   const std::function<void(const std::string&, std::size_t)>& f) {
  std::string line;
  std::size_t number = 0;
  bool any = false;
  while (std::getline(in, line)) {
    ++number;
    if (is_blank(line)) continue;
    if (!any && line.starts_with("PK\x03\x04")) {
      throw InputError(source, {.expected = "JSON Lines",
                                .found = "an archive",
                                .advice = "skyway-info says what is in it"});
    }
    any = true;
    f(line, number);
  }
  if (!any) {
    throw InputError(source, {.expected = "at least one record",
                              .found = "an empty stream",
                              .advice = "look at what the tool before said"});
  }
}

}  // namespace geom
