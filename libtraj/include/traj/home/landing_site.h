#pragma once

// Landing sites: where a vehicle may come down when it leaves its mission, from GeoJSON.
//
// Example:
//   std::istringstream in(R"({"type":"Feature","properties":{"id":"pad-1"},)"
//                         R"("geometry":{"type":"Point","coordinates":[1,1]}})");
//   const auto sites = traj::read_sites(in, "sites.geojson", map.spec().frame, {.local = true});
//   const traj::LandingSite pad = traj::landing_site(scene, sites[0], "sites.geojson");
//   assert(pad.id == "pad-1" && pad.ground.z() == 0 && pad.above.z() > 0);

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geom/collision/collision.h"
#include "geom/shape/polygon.h"

namespace traj {

using geom::Vec3;

// As a file draws it, in the map's coordinates.
struct DrawnSite {
  std::string id;
  std::size_t feature = 0;            // of the file, from 1
  geom::Polygon outline;              // of a point: its outer ring has one point
  std::optional<double> ground = {};  // z of the ground, metres, if the file says it
};

struct SiteReading {
  bool local = false;  // coordinates are the map's own metres, not longitude and latitude
};

// Points and polygons of a FeatureCollection, a Feature or a geometry. The name is the member "id"
// of a feature, else its property "id" or "name", else "site-" and its number. The ground is the
// property "ground" (the map's z), or a point's third coordinate: of a local file the map's z, else
// metres above sea level as the map's origin counts them. Throws InputError(source, …) for
// malformed JSON, another geometry or CRS, places that cannot be, an id that comes twice, a file
// without sites; and without `local` for a frame that has no origin.
std::vector<DrawnSite> read_sites(std::istream& in, std::string_view source,
                                  const geom::Frame& frame, const SiteReading& reading);

// A place to land: the vehicle sinks straight from `above` to `ground`.
struct LandingSite {
  std::string id;
  Vec3 ground = Vec3::Zero();  // m: on the ground, or on the roof, that is below it
  Vec3 above = Vec3::Zero();   // m: free, and so is the way down
};

// m between the ground and the vehicle's lower side, with its margin, at `above`, if the map is so
// high.
inline constexpr double kApproachHeight = 5;

inline constexpr double kLevelGround = 0.5;  // m by which a file may be wrong about the ground

// Where the vehicle of the scene lands on the site. On a point: there. On a polygon: at the place
// of a grid of 33 by 33 over its bounding box that is furthest from its edges, the vehicle with
// its margin inside, and where it may land. Without `ground` the highest top below counts. Throws
// InputError(source, …) with the feature and the reason if there is no such place: it is outside
// of the map, inside a building, on a roof edge (the ground below the vehicle and its margin is not
// whole and level), the ground is not where the file says, or the way down is not clear.
LandingSite landing_site(const geom::CollisionScene& scene, const DrawnSite& site,
                         std::string_view source);

// Why the vehicle cannot come down on that place, in words; empty: it can. Nothing is sampled.
std::string landing_fault(const geom::CollisionScene& scene, const Vec3& above, const Vec3& ground);

}  // namespace traj
