#include "traj/mission/formats/placement.h"

#include <fmt/format.h>

#include "geom/base/error.h"
#include "geom/base/usage_error.h"
#include "geom/import/volume_keep_out.h"
#include "geom/map/geographic_frame.h"

namespace traj {

MissionFrame Placement::mission_frame(const geom::Frame& frame) const {
  if (origin) {
    geom::Frame placed = frame;
    placed.origin = origin;
    if (!geom::counts_from_origin(placed)) {
      throw geom::UsageError(
          fmt::format("the map has the coordinates of \"{}\", which do not count from a place, so "
                      "--origin cannot say where they are: make the map from data in metres about "
                      "that place",
                      frame.crs.substr(0, 60)));
    }
    return {*origin, geoid, true, geoid_grid};
  }
  if (!geom::counts_from_origin(frame)) {
    throw geom::UsageError(
        "the map has no origin on Earth: give --origin latitude,longitude,height");
  }
  return {*frame.origin, geoid, geom::knows_height(frame), geoid_grid};
}

void require_near_origin(const geom::Polyline& enu, const geom::GeodeticOrigin& origin,
                         const std::string& id) {
  constexpr double kFurthest = 2e5;  // metres
  for (const geom::Vec3& p : enu) {
    if (p.head<2>().norm() <= kFurthest) continue;
    throw geom::InputError(
        id,
        {.expected = fmt::format("a flight within 200 km of the origin, latitude {}, longitude {}",
                                 origin.latitude, origin.longitude),
         .found = fmt::format("[{}, {}] m from it", p.x(), p.y()),
         .advice = "give the origin from which the map's coordinates count"});
  }
}

}  // namespace traj
