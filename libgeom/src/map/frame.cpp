#include "geom/map/frame.h"

namespace geom {

std::string_view name(Axes axes) { return axes == Axes::enu ? "enu" : "neu"; }

std::optional<Axes> axes_from_name(std::string_view word) {
  if (word == "enu") return Axes::enu;
  if (word == "neu") return Axes::neu;
  return std::nullopt;
}

Vec3 to_enu(Axes axes, const Vec3& v) { return axes == Axes::enu ? v : Vec3(v.y(), v.x(), v.z()); }

Aabb to_enu(Axes axes, const Aabb& box) { return {to_enu(axes, box.min), to_enu(axes, box.max)}; }

}  // namespace geom
