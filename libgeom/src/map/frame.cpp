#include "geom/map/frame.h"

namespace geom {

Vec3 to_enu(Axes axes, const Vec3& v) { return axes == Axes::enu ? v : Vec3(v.y(), v.x(), v.z()); }

Aabb to_enu(Axes axes, const Aabb& box) { return {to_enu(axes, box.min), to_enu(axes, box.max)}; }

}  // namespace geom
