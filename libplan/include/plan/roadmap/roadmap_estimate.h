#pragma once

// The size and cost of a roadmap, estimated from some of its tiles before it is built.
//
// Example:
//   double now = 0;
//   const auto clock = [&] { return now += 1e-3; };  // of a real program: a steady clock
//   const plan::RoadmapEstimate estimate = plan::estimate_roadmap(scene, {}, clock);
//   std::cout << "about " << estimate.bytes / 1e6 << " MB\n";

#include <cstddef>
#include <functional>
#include <string>

#include "plan/roadmap/roadmap.h"

namespace plan {

struct RoadmapEstimate {
  double bends = 0;
  double edges = 0;
  double bytes = 0;    // of its file
  double seconds = 0;  // of one core, by the caller's clock
};

// Builds a few tiles here and there, each with some hundred boxes, and takes all others to be like
// them. `clock` gives seconds, from any beginning. Costs what those tiles cost, and the map's table
// of tiles.
RoadmapEstimate estimate_roadmap(const geom::CollisionScene& scene, const RoadmapSpec& spec,
                                 const std::function<double()>& clock);

// What a roadmap of boxes that are spread over an area may take at most, about, before any is
// built: 9 bends a box, and for each a neighbour a metre of reach, as made-up cities have; and all
// pairs of bends in neighbouring squares as wide as the reach are looked at. On San Francisco it is
// a third of that. Of no map in particular, so that it is the same on every machine.
RoadmapEstimate rough_estimate(std::size_t boxes, double reach, const geom::Aabb& area);

// "about 1.2 million bends, 30 million edges and 0.3 GB, and take about 4 minutes of a core"
std::string in_words(const RoadmapEstimate& estimate);

}  // namespace plan
