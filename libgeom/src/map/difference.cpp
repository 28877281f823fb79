#include "geom/map/difference.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <tuple>

#include "geom/text/json_line.h"

namespace geom {
namespace {

bool comes_before(const ChangedBox& a, const ChangedBox& b) {
  return std::tie(a.box, a.label, a.time) < std::tie(b.box, b.label, b.time);
}

std::vector<ChangedBox> sorted(const BoxMap& map) {
  std::vector<ChangedBox> out;
  const auto boxes = map.boxes();
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Aabb& b = boxes[i];
    out.push_back({{b.min[0], b.min[1], b.min[2], b.max[0], b.max[1], b.max[2]},
                   map.labels()[map.label()[i]],
                   map.time(i),
                   map.ids()[i]});
  }
  std::sort(out.begin(), out.end(), comes_before);
  return out;
}

}  // namespace

MapDifference difference(const BoxMap& before, const BoxMap& after) {
  const BoxMapSpec& a = before.spec();
  const BoxMapSpec& b = after.spec();
  MapDifference out{{}, {}, a.frame == b.frame, a.bounds == b.bounds, a.epoch == b.epoch};
  const auto was = sorted(before);
  const auto is = sorted(after);
  std::set_difference(was.begin(), was.end(), is.begin(), is.end(), std::back_inserter(out.removed),
                      comes_before);
  std::set_difference(is.begin(), is.end(), was.begin(), was.end(), std::back_inserter(out.added),
                      comes_before);
  return out;
}

std::string to_json_line(std::string_view change, const ChangedBox& box) {
  JsonLine line;
  line.add("type", "box").add("change", change).add("id", box.id);
  line.add("min", std::span(box.box).first(3)).add("max", std::span(box.box).last(3));
  line.add("label", box.label);
  if (std::isfinite(box.time.from)) line.add("from", box.time.from);
  if (std::isfinite(box.time.until)) line.add("until", box.time.until);
  return line.line();
}

}  // namespace geom
