#include "geom/map/statistics.h"

#include <algorithm>
#include <numeric>

#include "geom/map/box_index.h"

namespace geom {
namespace {

Quartet quartet(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  return {values.front(), values[(values.size() - 1) / 2],
          std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size()),
          values.back()};
}

}  // namespace

MapStatistics statistics(const BoxMap& map) {
  MapStatistics out;
  std::vector<double> heights;
  const auto boxes = map.boxes();
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    heights.push_back(boxes[i].max.z() - boxes[i].min.z());
    out.flat += (boxes[i].min.array() == boxes[i].max.array()).any();
    out.unknown += map.labels()[map.label()[i]] == "unknown";
  }
  std::vector<double> counts;
  for (const Tile& tile : map.tiles()) counts.push_back(static_cast<double>(tile.count));
  out.height = quartet(std::move(heights));
  out.boxes_per_tile = quartet(std::move(counts));
  return out;
}

Overlaps overlaps(const BoxMap& map) {
  const auto boxes = map.boxes();
  BoxIndex index(index_cell(boxes));
  for (std::size_t i = 0; i < boxes.size(); ++i) index.add(i, boxes[i]);
  Overlaps out;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    bool contained = false;
    for (const std::size_t k : index.near(boxes[i])) {
      if (k == i) continue;
      const bool meet = (boxes[i].min.array() < boxes[k].max.array()).all() &&
                        (boxes[k].min.array() < boxes[i].max.array()).all();
      out.pairs += meet && k > i;
      const bool inside = contains(boxes[k], boxes[i].min) && contains(boxes[k], boxes[i].max);
      contained = contained || (inside && (k < i || !(boxes[k] == boxes[i])));
    }
    out.contained += contained;
  }
  return out;
}

}  // namespace geom
