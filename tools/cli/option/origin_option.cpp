#include "origin_option.h"

#include <fmt/format.h>

#include <cmath>

#include "cli/answer/exit.h"
#include "numbers_option.h"

namespace cli {

geom::GeodeticOrigin origin_from(std::string_view text, std::string_view or_word) {
  auto v = parse_numbers(text, 3);
  if (!v && (v = parse_numbers(text, 2))) v->push_back(0);
  if (v && std::abs((*v)[0]) <= 90 && std::abs((*v)[1]) <= 180) return {(*v)[0], (*v)[1], (*v)[2]};
  throw UsageError(
      fmt::format("--origin: expected LATITUDE,LONGITUDE in degrees, and a height in metres where "
                  "it is known{}{}, found \"{}\"",
                  or_word.empty() ? "" : ", or ", or_word, text));
}

}  // namespace cli
