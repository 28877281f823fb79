#include "geom/picture/look.h"

#include <algorithm>
#include <cmath>

#include "geom/map/label_colour.h"
#include "windows.h"

namespace geom::picture {
namespace {

constexpr Colour kStone{222, 206, 182};  // of low boxes
constexpr Colour kSteel{126, 152, 186};  // of the highest

Colour mixed(const Colour& a, const Colour& b, double share) {
  const auto part = [share](int low, int high) {
    return static_cast<std::uint8_t>(std::clamp(low + (high - low) * share + 0.5, 0.0, 255.0));
  };
  return {part(a.r, b.r), part(a.g, b.g), part(a.b, b.b)};
}

}  // namespace

std::vector<Colour> box_colours(const BoxMap& map) {
  const bool labelled = map.labels().size() > 1;
  std::vector<Colour> label_colours;
  for (std::uint32_t label = 0; label < map.labels().size(); ++label) {
    const Rgb8 c = label_colour(label, map.labels()[label]);
    label_colours.push_back({c[0], c[1], c[2]});
  }
  const double floor = map.spec().bounds.min.z();
  double top = floor + 1;
  for (std::size_t i = 0; i < map.size(); ++i) {
    const bool air = is_keep_out(map.labels()[map.label()[i]]);
    if (!air) top = std::max(top, map.boxes()[i].max.z());
  }
  std::vector<Colour> out;
  out.reserve(map.size());
  for (std::size_t i = 0; i < map.size(); ++i) {
    if (labelled && map.label()[i] != 0) {
      out.push_back(label_colours[map.label()[i]]);
      continue;
    }
    const double height = std::max(0.0, map.boxes()[i].max.z() - floor);
    out.push_back(mixed(kStone, kSteel, std::min(1.0, std::sqrt(height / (top - floor)))));
  }
  return out;
}

Look look_of(const BoxMap& map) {
  const Aabb ground = to_enu(map.spec().frame.axes, map.spec().bounds);
  return {box_colours(map), windows_of(map), ground, grid_lines(ground)};
}

}  // namespace geom::picture
