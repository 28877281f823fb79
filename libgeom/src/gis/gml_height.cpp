#include "gml_height.h"

#include <fmt/format.h>

#include "gml_words.h"
#include "import/written_height.h"

namespace geom::gis {
namespace {

const Words kTops = {"highestRoofEdge", "highestPoint", "topOfConstruction"};
const Words kFeet = {"lowestGroundPoint", "bottomOfConstruction"};

}  // namespace

std::string GmlHeight::text() const {
  if (kTops.contains(high) && kFeet.contains(low)) return value;
  return fmt::format("from {} to {}: {}", low, high, value);
}

std::string GmlHeight::higher(const std::string& a, const std::string& b) {
  const auto known_a = parse_highest(a);
  const auto known_b = parse_highest(b);
  if (!known_a || !known_b) return known_a ? a : b;
  return *known_a >= *known_b ? a : b;
}

}  // namespace geom::gis
