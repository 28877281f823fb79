#include "geom/map/geodetic_outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geom/base/error.h"
#include "shape/simple_ring.h"

namespace geom {
namespace {

constexpr int kCorners = 256;           // of a circle
constexpr double kLargestRadius = 1e5;  // m

std::vector<Vec2> around(const Vec2& centre, double radius) {
  std::vector<Vec2> ring;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / kCorners;
    ring.push_back(centre + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

// An edge that is straight in degrees bends by less than this per metre: parallels most. Geodesics
// bend less by far, x / R^2 at x metres east of the origin.
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

class Placing {
 public:
  Placing(const GeodeticOrigin& origin, std::string_view what, std::string_view source)
      : earth_(origin), origin_(origin), what_(what), source_(source) {}

  MapOutline circle(const GeodeticOutline& outline, CircleSide side) const {
    const Vec2 centre = on_map(outline.centre);
    const double radius = outline.radius;
    if (!(radius > 0 && radius <= kLargestRadius)) {
      refuse({.key = fmt::format("the radius of {}", what_),
              .expected = "above 0 and within 1e5 m",
              .found = fmt::to_string(radius)});
    }
    const double beside =
        side == CircleSide::within ? 1 : 1 / std::cos(std::numbers::pi / kCorners);
    return {around(centre, radius * beside), stretch(centre, radius)};
  }

  MapOutline polygon(const GeodeticOutline& outline) const {
    MapOutline out;
    double furthest = 0;
    for (const GeodeticPlace& place : outline.ring) {
      const Vec2 p = on_map(place);
      furthest = std::max(furthest, std::abs(place.latitude));
      if (out.ring.empty() || p != out.ring.back()) out.ring.push_back(p);
    }
    if (out.ring.size() > 1 && out.ring.front() == out.ring.back()) out.ring.pop_back();
    if (!is_simple(out.ring)) {
      refuse({.key = std::string(what_),
              .expected = "a ring of three places or more whose edges do not cross",
              .found = fmt::format("{} places{}", outline.ring.size(),
                                   out.ring.size() < 3 ? "" : " and edges that cross")});
    }
    out.bulge = bulge_of(out.ring, furthest);
    return out;
  }

 private:
  [[noreturn]] void refuse(Fault fault) const { throw InputError(source_, std::move(fault)); }

  Vec2 on_map(const GeodeticPlace& place) const {
    if (!is_near(origin_, place.latitude, place.longitude)) {
      refuse({.expected = fmt::format("{} near the origin {} {}", what_, origin_.latitude,
                                      origin_.longitude),
              .found = fmt::format("{} {}", place.latitude, place.longitude)});
    }
    Vec2 p;
    earth_.from_geodetic(place.latitude, place.longitude, p.x(), p.y());
    return p;
  }

  const GeographicFrame earth_;
  const GeodeticOrigin& origin_;
  std::string_view what_;
  std::string_view source_;
};

}  // namespace

bool is_near(const GeodeticOrigin& origin, double latitude, double longitude) {
  return std::abs(latitude) <= 90 && std::abs(latitude - origin.latitude) <= 10 &&
         std::abs(std::remainder(longitude - origin.longitude, 360)) <= 20;
}

MapOutline outline_on_map(const GeodeticOutline& outline, const GeodeticOrigin& origin,
                          CircleSide side, std::string_view what, std::string_view source) {
  const Placing placing(origin, what, source);
  return outline.ring.empty() ? placing.circle(outline, side) : placing.polygon(outline);
}

}  // namespace geom
