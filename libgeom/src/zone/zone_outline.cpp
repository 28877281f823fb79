#include "zone_outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geom/base/error.h"
#include "geom/map/geographic_frame.h"

namespace geom::zone {
namespace {

constexpr double kDegree = M_PI / 180;
constexpr double kShortestDegree = 110500;  // m of a meridian
constexpr double kShortestRadius = 6.3e6;   // m, less than any of the Earth's
constexpr double kRounding = 1e-6;          // m: far more than projecting and turning axes round by
constexpr double kAside = 1e-4;             // degrees

// An edge that is straight in degrees or a shortest way bends from the straight one by less than
// this per metre: parallels bend most (geodetic_outline.h).
double bend(double latitude) {
  const double steepest = std::min(std::abs(latitude), 89.0) * kDegree;
  return (1 + std::tan(steepest)) / kShortestRadius;
}

double metres_of_degree(double latitude) {
  return kShortestDegree * std::cos(std::min(std::abs(latitude), 89.9) * kDegree);
}

SunArea grown(SunArea area, double metres) {
  const double latitude = std::max(std::abs(area.south), std::abs(area.north));
  const double north = metres / kShortestDegree + kAside;
  const double east = metres / metres_of_degree(latitude + north) + kAside;
  return {area.south - north, area.north + north, area.west - east, area.east + east};
}

void add(SunArea& area, double latitude, double longitude) {
  area.south = std::min(area.south, latitude);
  area.north = std::max(area.north, latitude);
  area.west = std::min(area.west, longitude);
  area.east = std::max(area.east, longitude);
}

double longest_edge(const std::vector<Vec2>& ring) {
  double longest = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    longest = std::max(longest, (ring[(i + 1) % ring.size()] - ring[i]).norm());
  }
  return longest;
}

class Placing {
 public:
  Placing(const Frame& frame, const std::string& item, const std::string& source)
      : frame_(frame), earth_(*frame.origin), item_(item), source_(source) {}

  std::vector<Vec2> ring(const std::vector<GeodeticPlace>& places, double& bulge) const {
    std::vector<Vec2> out;
    double furthest = 0;
    for (const GeodeticPlace& place : places) {
      if (!is_near(*frame_.origin, place.latitude, place.longitude)) {
        throw InputError(
            source_, {.item = item_,
                      .expected = "a zone within 10 degrees of latitude and 20 of "
                                  "longitude of the map's origin",
                      .found = fmt::format("a corner at {} {}", place.latitude, place.longitude)});
      }
      furthest = std::max(furthest, std::abs(place.latitude));
      Vec3 enu = Vec3::Zero();
      earth_.from_geodetic(place.latitude, place.longitude, enu.x(), enu.y());
      out.push_back(to_enu(frame_.axes, enu).head<2>());
    }
    const double longest = longest_edge(out);
    bulge = std::max(bulge, bend(furthest) * longest * longest / 8 + kRounding);
    return out;
  }

 private:
  const Frame& frame_;
  GeographicFrame earth_;
  const std::string& item_;
  const std::string& source_;
};

}  // namespace

SunArea area_of(const BoxMapSpec& spec) {
  const GeodeticOrigin& origin = *spec.frame.origin;
  const GeographicFrame earth(origin);
  const Aabb bounds = to_enu(spec.frame.axes, spec.bounds);
  SunArea out{90, -90, 1e3, -1e3};
  for (const double x : {bounds.min.x(), bounds.max.x()}) {
    for (const double y : {bounds.min.y(), bounds.max.y()}) {
      double latitude = 0;
      double longitude = 0;
      earth.to_geodetic(x, y, latitude, longitude);
      add(out, latitude, origin.longitude + std::remainder(longitude - origin.longitude, 360));
    }
  }
  const double across = (bounds.max - bounds.min).head<2>().norm();
  return grown(out, bend(std::max(std::abs(out.south), std::abs(out.north))) * across * across);
}

SunArea area_of(const GeodeticOutline& outline, double longitude) {
  const auto east = [&](const GeodeticPlace& p) {
    return longitude + std::remainder(p.longitude - longitude, 360);
  };
  if (outline.ring.empty()) {
    const GeodeticPlace& c = outline.centre;
    return grown({c.latitude, c.latitude, east(c), east(c)}, outline.radius);
  }
  // Each corner beside the one before, so that a ring that crosses the antimeridian stays whole.
  double at = east(outline.ring.front());
  SunArea out{90, -90, 1e3, -1e3};
  for (const GeodeticPlace& p : outline.ring) {
    at += std::remainder(p.longitude - at, 360);
    add(out, p.latitude, at);
  }
  const double furthest = std::max(std::abs(out.south), std::abs(out.north));
  const double across = std::hypot(out.north - out.south, out.east - out.west) * 111700;
  return grown(out, bend(furthest) * across * across / 8);
}

bool apart(const SunArea& a, const SunArea& b) {
  return a.north < b.south || b.north < a.south || a.east < b.west || b.east < a.west;
}

PlacedOutline placed(const ZoneVolume& volume, const Frame& frame, const std::string& item,
                     const std::string& source) {
  PlacedOutline out;
  if (volume.outline.ring.empty()) {
    const MapOutline circle =
        outline_on_map(volume.outline, *frame.origin, CircleSide::around, item, source);
    for (const Vec2& p : circle.ring) {
      out.polygon.outer.push_back(to_enu(frame.axes, Vec3(p.x(), p.y(), 0)).head<2>());
    }
    out.bulge = circle.bulge + kRounding;
    return out;
  }
  const Placing placing(frame, item, source);
  out.polygon.outer = placing.ring(volume.outline.ring, out.bulge);
  for (const auto& hole : volume.holes) {
    out.polygon.holes.push_back(placing.ring(hole, out.bulge));
  }
  return out;
}

}  // namespace geom::zone
