#include "tell.h"

#include <fmt/format.h>

#include "geom/text/excerpt.h"

namespace cli {

void tell(const Common& common, std::string_view tool, std::string_view message) {
  constexpr std::size_t kLongest = 2000;  // bytes
  common.note(fmt::format("{}: {}\n", tool, geom::excerpt(message, kLongest)));
}

}  // namespace cli
