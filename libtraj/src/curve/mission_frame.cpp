#include "traj/curve/mission_frame.h"

#include <fmt/format.h>

#include "geom/base/error.h"

namespace traj {

double MissionFrame::sea_level(double latitude, double longitude) const {
  if (!geoid_grid) return geoid;
  if (const auto range = geoid_grid->over({latitude, latitude, longitude, longitude})) {
    return (range->least + range->most) / 2;
  }
  throw geom::InputError(
      "the geoid grid",
      {.expected = "one that knows the sea level everywhere on the way",
       .found = fmt::format("none at latitude {}, longitude {}", latitude, longitude)});
}

}  // namespace traj
