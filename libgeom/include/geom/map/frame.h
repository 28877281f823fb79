#pragma once

// What the axes of a map mean, and where its origin is on Earth.
//
// Example:
//   assert(geom::to_enu(geom::Axes::neu, geom::Vec3(1, 2, 3)) == geom::Vec3(2, 1, 3));
//   const geom::Frame frame{.axes = geom::Axes::enu, .origin = geom::GeodeticOrigin{47.4, 8.5, 0}};

#include <optional>
#include <string>
#include <string_view>

#include "geom/base/vec3.h"
#include "geom/shape/aabb.h"

namespace geom {

// enu: x east, y north, z up. neu: x north, y east, z up (left-handed), as in FCND tables.
enum class Axes { enu, neu };

// A yaw of the axes (from x towards y) as one of ENU axes, or back: radians.
inline double yaw_to_enu(Axes axes, double yaw) {
  return axes == Axes::enu ? yaw : 1.5707963267948966 - yaw;
}

struct GeodeticOrigin {
  double latitude = 0;   // degrees, WGS 84
  double longitude = 0;  // degrees
  double height = 0;     // metres above the ellipsoid

  friend bool operator==(const GeodeticOrigin&, const GeodeticOrigin&) = default;
};

struct Frame {
  Axes axes = Axes::enu;
  std::optional<GeodeticOrigin> origin;  // of (0, 0, 0), where known
  std::string crs;                       // as the source names it; empty when unknown

  friend bool operator==(const Frame&, const Frame&) = default;
};

std::string_view name(Axes axes);                      // "enu" or "neu"
std::optional<Axes> axes_from_name(std::string_view);  // the inverse; nothing for another word

// A vector or box of the map in east-north-up axes; each its own inverse.
Vec3 to_enu(Axes axes, const Vec3& v);
Aabb to_enu(Axes axes, const Aabb& box);

}  // namespace geom
