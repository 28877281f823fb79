#include "geom/map/near_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "geom/map/geographic_frame.h"

namespace geom {
namespace {

constexpr double kNear = 1e4;  // m

// Metres between the bounds and the ring's bounding rectangle; 0 where they meet.
double away(const Aabb& bounds, std::span<const Vec2> ring) {
  Vec2 low = ring.front();
  Vec2 high = ring.front();
  for (const Vec2& p : ring) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vec2 beside = (low - bounds.max.head<2>()).cwiseMax(bounds.min.head<2>() - high);
  return beside.cwiseMax(0).norm();
}

// Where the ring would be with latitudes and longitudes exchanged; empty where there is no such
// place.
std::vector<Vec2> exchanged(const Frame& frame, std::span<const Vec2> ring) {
  const GeographicFrame earth(*frame.origin);
  std::vector<Vec2> out;
  for (const Vec2& p : ring) {
    const Vec3 enu = to_enu(frame.axes, Vec3(p.x(), p.y(), 0));
    double latitude = 0;
    double longitude = 0;
    earth.to_geodetic(enu.x(), enu.y(), latitude, longitude);
    if (!(std::abs(longitude) <= 90)) return {};
    Vec3 other = Vec3::Zero();
    earth.from_geodetic(longitude, latitude, other.x(), other.y());
    out.push_back(to_enu(frame.axes, other).head<2>());
  }
  return out;
}

}  // namespace

std::optional<std::string> why_not_near(const BoxMapSpec& spec, const DrawnRing& outline) {
  const double distance = away(spec.bounds, outline.ring);
  if (distance == 0) return std::nullopt;
  if (outline.longitude_first) {
    const auto other = exchanged(spec.frame, outline.ring);
    if (!other.empty() && away(spec.bounds, other) == 0) {
      return fmt::format(
          "it is {:.0f} m from the map's bounds, and would meet them with latitude and longitude "
          "exchanged: GeoJSON has the longitude first; exchange them, or insist with --far",
          distance);
    }
  }
  const double side = (spec.bounds.max - spec.bounds.min).head<2>().norm();
  if (distance <= std::max(kNear, side)) return std::nullopt;
  return fmt::format(
      "expected a place near the map, found one {:.0f} km from its bounds: {}or insist with --far",
      distance / 1000,
      outline.longitude_first ? "GeoJSON has the longitude first; exchange them, "
                              : "give what lies on the map, ");
}

}  // namespace geom
