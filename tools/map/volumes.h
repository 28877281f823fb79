#pragma once

// Volumes that a map is to keep vehicles out of, as boxes.

#include <optional>
#include <string>

#include "cli/option/degrees.h"
#include "cli/run.h"
#include "geom/map/box_map.h"
#include "geom/map/make_map.h"
#include "near_map.h"

namespace verbs {

struct Volumes {
  const geom::BoxMapSpec& spec;
  double slack;  // metres that boxes may reach outside a volume
  // Of z = 0 above the ellipsoid, metres, where it is not as the frame says.
  std::optional<double> zero_height = {};

  bool far = false;  // whether volumes may lie anywhere

  // Of GeoJSON, or of volumes of ASTM F3548. `local`: in the map's metres. Warns of heights that
  // the reader does not know.
  geom::BoxTable keep_out(const std::string& path, bool local, const cli::MetresOption& metres,
                          const cli::Common& common) const;

  // What the fences of a mission's file forbid within the bounds: exclusions, and all outside of
  // each inclusion.
  geom::BoxTable fence(const std::string& path) const;

 private:
  void require_near(const DrawnRing& outline, std::uint64_t feature, const std::string& name) const;
};

}  // namespace verbs
