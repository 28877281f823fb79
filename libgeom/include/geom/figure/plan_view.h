#pragma once

// A figure of a map from above, with paths.
//
// Example:
//   const geom::figure::PlanLine line{"path", "q1", path, true};
//   const std::string svg = geom::figure::plan_view(map, {}, std::span(&line, 1));
//   assert(svg.find("path q1") != std::string::npos);

#include <span>
#include <string>
#include <vector>

#include "geom/map/box_map.h"
#include "geom/shape/polyline.h"

namespace geom::figure {

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

// The lines alone, with some room around them. One of them has a point (precondition).
std::string plan_view(std::span<const PlanLine> lines);

}  // namespace geom::figure
