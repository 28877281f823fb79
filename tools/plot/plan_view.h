#pragma once

// The city from above, with paths.

#include <span>
#include <string>
#include <vector>

#include "geom/map/box_map.h"
#include "geom/shape/polyline.h"

namespace plot {

struct PlanLine {
  std::string kind;  // "path", "trajectory" or "flight"
  std::string id;
  geom::Polyline points;  // ENU
  bool corners = false;   // its points are marked
};

struct PlanTree {
  std::vector<std::pair<geom::Vec3, geom::Vec3>> edges;  // ENU
};

// An SVG of the map in east-north axes: obstacles shaded by the height of their top, trees, and
// lines with their legend (of the first eight).
std::string plan_view(const geom::BoxMap& map, std::span<const PlanTree> trees,
                      std::span<const PlanLine> lines);

}  // namespace plot
