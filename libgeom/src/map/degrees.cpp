#include "geom/map/degrees.h"

#include <algorithm>
#include <cmath>

namespace geom {
namespace {

constexpr double kNear = 0.5;  // degrees

bool near_place(double latitude, double longitude, const GeodeticOrigin& origin) {
  return std::abs(latitude - origin.latitude) <= kNear &&
         std::abs(longitude - origin.longitude) <= kNear;
}

bool fractional(double v) { return v != std::floor(v); }

}  // namespace

bool look_like_degrees(const Frame& frame, std::span<const Vec3> points) {
  if (!frame.origin || points.empty()) return false;
  const GeodeticOrigin& at = *frame.origin;
  const auto all = [&](int latitude, int longitude) {
    return std::all_of(points.begin(), points.end(), [&](const Vec3& p) {
      return near_place(p[latitude], p[longitude], at) && fractional(p.x()) && fractional(p.y());
    });
  };
  return all(0, 1) || all(1, 0);
}

std::optional<SmallOutline> may_be_degrees(std::span<const Vec3> corners) {
  constexpr double kSmall = 2;  // m, or degrees: a country
  SmallOutline out{corners.front(), corners.front()};
  for (const Vec3& p : corners) {
    if (!fractional(p.x()) || !fractional(p.y())) return std::nullopt;
    out.low = out.low.cwiseMin(p);
    out.high = out.high.cwiseMax(p);
  }
  const Vec3 size = out.high - out.low;
  if (std::max(size.x(), size.y()) >= kSmall) return std::nullopt;
  return out;
}

}  // namespace geom
