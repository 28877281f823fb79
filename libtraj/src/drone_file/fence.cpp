#include "traj/drone_file/fence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geom/base/error.h"
#include "geom/shape/simple_ring.h"

namespace traj {
namespace {

using geom::Vec2;

constexpr int kCorners = 256;           // of a circle
constexpr double kLargestRadius = 1e5;  // m

Vec2 on_map(const geom::GeographicFrame& earth, const geom::GeodeticOrigin& origin,
            const geom::GeodeticPlace& place, std::string_view source) {
  if (!is_near(origin, place.latitude, place.longitude)) {
    throw geom::InputError(
        source, fmt::format("expected a fence near the origin {} {}, found {} {}", origin.latitude,
                            origin.longitude, place.latitude, place.longitude));
  }
  Vec2 p;
  earth.from_geodetic(place.latitude, place.longitude, p.x(), p.y());
  return p;
}

std::vector<Vec2> around(const Vec2& centre, double radius) {
  std::vector<Vec2> ring;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    ring.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

std::vector<Vec2> circle(const GeodeticFence& fence, const Vec2& centre, std::string_view source) {
  if (!(fence.radius > 0 && fence.radius <= kLargestRadius)) {
    throw geom::InputError(
        source, fmt::format("the radius of a fence must be above 0 and within 1e5 m, found {}",
                            fence.radius));
  }
  const double beside = fence.inclusion ? 1 : 1 / std::cos(std::numbers::pi / kCorners);
  return around(centre, fence.radius * beside);
}

// An edge that is straight in degrees bends by less than this per metre: parallels most.
double bend(double latitude) {
  const double steepest = std::min(std::abs(latitude), 89.0) * std::numbers::pi / 180;
  return (1 + std::tan(steepest)) / 6.3e6;
}

// How much longer than on Earth a radius is on the map, whose scale grows with the distance east of
// the origin: by x^2 / (2 R^2).
double stretch(const Vec2& centre, double radius) {
  const double east = std::abs(centre.x()) + radius;
  return radius * east * east / (2 * 6.3e6 * 6.3e6);
}

double bulge_of(const std::vector<Vec2>& ring, double latitude) {
  double longest = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    longest = std::max(longest, (ring[(i + 1) % ring.size()] - ring[i]).norm());
  }
  return bend(latitude) * longest * longest / 8;
}

}  // namespace

bool is_near(const geom::GeodeticOrigin& origin, double latitude, double longitude) {
  return std::abs(latitude) <= 90 && std::abs(latitude - origin.latitude) <= 10 &&
         std::abs(std::remainder(longitude - origin.longitude, 360)) <= 20;
}

Fence fence_on_map(const GeodeticFence& fence, const geom::GeodeticOrigin& origin,
                   std::string_view source) {
  const geom::GeographicFrame earth(origin);
  if (fence.ring.empty()) {
    const Vec2 centre = on_map(earth, origin, fence.centre, source);
    return {fence.inclusion, circle(fence, centre, source), stretch(centre, fence.radius)};
  }
  Fence out{fence.inclusion, {}, 0};
  double furthest = 0;
  for (const geom::GeodeticPlace& place : fence.ring) {
    const Vec2 p = on_map(earth, origin, place, source);
    furthest = std::max(furthest, std::abs(place.latitude));
    if (out.ring.empty() || p != out.ring.back()) out.ring.push_back(p);
  }
  if (out.ring.size() > 1 && out.ring.front() == out.ring.back()) out.ring.pop_back();
  if (!geom::is_simple(out.ring)) {
    throw geom::InputError(
        source, fmt::format("a fence must be a ring of three places or more whose edges do not "
                            "cross, found {} places{}",
                            fence.ring.size(), out.ring.size() < 3 ? "" : " and edges that cross"));
  }
  out.bulge = bulge_of(out.ring, furthest);
  return out;
}

}  // namespace traj
