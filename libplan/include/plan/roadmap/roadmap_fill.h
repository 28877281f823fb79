#pragma once

// A roadmap that is worked out where searches come to it, and kept.

#include <memory>
#include <optional>

#include "plan/roadmap/roadmap.h"

namespace plan {

class TileSource;  // libplan/src/roadmap/tile_source.h

// Searches find in it what they find in build_roadmap(scene, spec), whatever of it is known
// already: bends of a tile are made when it is first touched, edges of a bend when it is first
// settled. Several searches may use one at once, from several threads; the scene must outlive it.
class RoadmapFill {
 public:
  // `known`: what earlier ones came to on the same map, for the same spec.
  RoadmapFill(const geom::CollisionScene& scene, const RoadmapSpec& spec,
              std::optional<Roadmap> known = std::nullopt);
  ~RoadmapFill();

  const RoadmapSpec& spec() const;
  bool grew() const;  // since it was made

  // What was known, and what was worked out since; with what `others` came to meanwhile. Throws
  // geom::InputError where what was known, or they, say what no roadmap says.
  Roadmap known(const std::optional<Roadmap>& others = std::nullopt) const;

  TileSource& source();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace plan
