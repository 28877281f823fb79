#include "geom/text/record_lines.h"

#include <algorithm>

#include "geom/base/error.h"

namespace geom {
namespace {

constexpr std::size_t kRoom = std::size_t{1} << 16;  // bytes that a line gets at first, at most

bool is_blank(const std::string& line) {
  return line.find_first_not_of(" \t\r") == std::string::npos;
}

}  // namespace

std::optional<RecordLine> RecordLines::next() {
  RecordLine line;
  line.text.reserve(room_);
  while (std::getline(in_, line.text)) {
    ++number_;
    if (is_blank(line.text)) continue;
    if (!any_ && line.text.starts_with("PK\x03\x04")) {
      throw InputError(source_, {.expected = "JSON Lines",
                                 .found = "an archive",
                                 .advice = "skyway-info says what is in it"});
    }
    any_ = true;
    line.number = number_;
    room_ = std::min(line.text.size(), kRoom);
    return line;
  }
  if (!any_) {
    throw InputError(source_, {.expected = "at least one record",
                               .found = "an empty stream",
                               .advice = "look at what the tool before said"});
  }
  return std::nullopt;
}

void for_each_line(std::istream& in, const std::string& source,
                   const std::function<void(const std::string&, std::size_t)>& f) {
  RecordLines lines(in, source);
  while (const auto line = lines.next()) f(line->text, line->number);
}

}  // namespace geom
