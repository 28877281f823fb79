#pragma once

// A roadmap that is built where searches come to it, and kept.
//
// Example:
//   plan::RoadmapFill fill(scene, {});
//   plan::Planner planner(scene, nullptr, fill);
//   const plan::PlanResult result = planner.plan({1, 1, 1}, {9, 1, 1});
//   if (fill.grew()) {
//     std::ostringstream out;  // keeps what this search built
//     plan::write_roadmap(out, fill.known());
//   }

#include <memory>
#include <optional>

#include "plan/roadmap/roadmap.h"

namespace plan {

class TileSource;  // libplan/src/roadmap/tile_source.h

// Searches find the same paths as in build_roadmap(scene, spec), however much of it is built
// already. The bends of a tile are made when it is first touched, the edges of a bend when it is
// first settled. Several searches may use one at once, from several threads; the scene must outlive
// it.
class RoadmapFill {
 public:
  // `known`: a part that was built before, for the same map and spec.
  RoadmapFill(const geom::CollisionScene& scene, const RoadmapSpec& spec,
              std::optional<Roadmap> known = std::nullopt);
  ~RoadmapFill();

  const RoadmapSpec& spec() const;
  bool grew() const;  // since it was made

  // The known part, the part built since, and the part that `others` built meanwhile. Throws
  // geom::InputError if the known part or `others` is no valid roadmap.
  Roadmap known(const std::optional<Roadmap>& others = std::nullopt) const;

  TileSource& source();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace plan
