#include "geom/text/last_end.h"

#include <algorithm>

namespace geom {

std::size_t up_to_last_end(std::string_view lines) {
  if (lines.size() < 2) return 0;
  const std::size_t before = lines.rfind('\n', lines.size() - 2);
  const std::size_t line = before == std::string_view::npos ? 0 : before + 1;
  const std::size_t end = lines.find_last_of(",\t ");
  if (end != std::string_view::npos && end > line) return end;
  return std::max(line, lines.size() - 2);
}

}  // namespace geom
