#include "geom/base/format.h"

#include <algorithm>

namespace geom {

const Format* recognise(std::string_view head, Formats formats) {
  head = head.substr(0, kFormatHead);
  const auto found = std::find_if(formats.begin(), formats.end(), [&](const Format* format) {
    return format->begins && format->begins(head);
  });
  return found == formats.end() ? nullptr : *found;
}

const Format* format_named(std::string_view word, Formats formats) {
  const auto found = std::find_if(formats.begin(), formats.end(),
                                  [&](const Format* format) { return format->word == word; });
  return found == formats.end() || word.empty() ? nullptr : *found;
}

bool reads(std::string_view tool, const Format& format) {
  return std::find(format.readers.begin(), format.readers.end(), tool) != format.readers.end();
}

}  // namespace geom
