#include <fmt/format.h>

#include <GeographicLib/Geocentric.hpp>
#include <algorithm>
#include <cmath>

#include "geom/base/error.h"
#include "geom/map/geographic_frame.h"
#include "geom/model/place_model.h"

namespace geom {
namespace {

constexpr double kHighest = 1e5;   // metres from the ellipsoid
constexpr double kFurthest = 2e5;  // metres from the origin

std::vector<GeodeticPlace> places_of(const Model& model, std::string_view source) {
  const auto& earth = GeographicLib::Geocentric::WGS84();
  std::vector<GeodeticPlace> out;
  out.reserve(model.mesh.vertices.size());
  for (const Vec3& v : model.mesh.vertices) {
    GeodeticPlace place;
    earth.Reverse(v.x(), v.y(), v.z(), place.latitude, place.longitude, place.height);
    if (!(std::abs(place.height) <= kHighest)) {
      throw InputError(source,
                       {.expected = "earth-centred coordinates within 100 km of the ellipsoid",
                        .found = fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z())});
    }
    out.push_back(place);
  }
  return out;
}

GeodeticOrigin middle(const std::vector<GeodeticPlace>& places) {
  GeodeticOrigin low{90, 180, 0};
  GeodeticOrigin high{-90, -180, 0};
  for (const GeodeticPlace& p : places) {
    // Beside the first, so that a model over the 180th meridian is not spread around the Earth.
    const double longitude =
        places.front().longitude + std::remainder(p.longitude - places.front().longitude, 360.0);
    low = {std::min(low.latitude, p.latitude), std::min(low.longitude, longitude), 0};
    high = {std::max(high.latitude, p.latitude), std::max(high.longitude, longitude), 0};
  }
  return {0.5 * (low.latitude + high.latitude),
          std::remainder(0.5 * (low.longitude + high.longitude), 360.0), 0};
}

double longest_side(const TriangleMesh& mesh) {
  double longest = 0;
  for (const MeshTriangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 side = mesh.vertices[t.corners[i]] - mesh.vertices[t.corners[(i + 1) % 3]];
      longest = std::max(longest, side.norm());
    }
  }
  return longest;
}

}  // namespace

PlacedModel place_on_map(Model& model, const std::optional<GeodeticOrigin>& origin,
                         std::string_view source) {
  const std::vector<GeodeticPlace> places = places_of(model, source);
  if (places.empty()) throw InputError(source, {.expected = "triangles", .found = "none"});
  PlacedModel out;
  out.frame.origin = origin ? *origin : middle(places);
  const GeographicFrame frame(*out.frame.origin);
  // Between two points at a distance L, a map whose scale differs from 1 by less than 1e-3 (so does
  // transverse Mercator within 200 km) and whose heights follow an Earth of radius R bends by at
  // most L^2 / (8 R) (1 + 1e-2); over a triangle by no more than its longest side: twice that here.
  constexpr double kRadius = 6.3e6;
  const double longest = longest_side(model.mesh);
  out.bend = longest * longest / (4 * kRadius) + 1e-6;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vec3 enu = frame.enu(places[i]);
    if (!(enu.head<2>().norm() <= kFurthest)) {
      throw InputError(
          source, {.expected = fmt::format(
                       "a model within 200 km of the origin (latitude {}, longitude {})",
                       out.frame.origin->latitude, out.frame.origin->longitude),
                   .found = fmt::format("a vertex {:.0f} km away", enu.head<2>().norm() / 1000)});
    }
    model.mesh.vertices[i] = enu;
  }
  return out;
}

}  // namespace geom
