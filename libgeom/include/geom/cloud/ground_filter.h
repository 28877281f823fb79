#pragma once

// Which points are ground: by the class that the file gives them, or by their shape.
//
// Example:
//   geom::GroundFilter filter({}, "auto");
//   const std::vector<geom::CloudPoint> points = {{geom::Vec3(0, 0, 0), geom::kGroundClass},
//                                                 {geom::Vec3(0, 0, 9), 6}};  // 6: building
//   for (const geom::CloudPoint& p : points) filter.add(p);
//   filter.finish();
//   assert(filter.is_ground(points[0]) && !filter.is_ground(points[1]));

#include <string>

#include "geom/cloud/las_class.h"
#include "geom/cloud/point_cloud.h"
#include "geom/map/ground_grid.h"

namespace geom {

// Add all points, finish(), then ask. `by`: "class", "shape" or "auto", which is the class where a
// point has that of ground. What the file calls noise is not looked at, nor ever ground by shape.
class GroundFilter {
 public:
  GroundFilter(const GroundSpec& spec, const std::string& by)
      : grid_(spec), auto_(by == "auto"), by_class_(by == "class") {}

  void add(const CloudPoint& p) {
    by_class_ |= auto_ && p.cls == kGroundClass;
    if (!is_noise_class(p.cls)) grid_.add(p.position);
  }

  void finish() {
    if (!by_class_) grid_.finish();
  }

  bool is_ground(const CloudPoint& p) const {
    if (by_class_) return p.cls == kGroundClass;
    return !is_noise_class(p.cls) && grid_.is_ground(p.position);
  }

  std::string by() const { return by_class_ ? "class" : "shape"; }

 private:
  GroundGrid grid_;
  bool auto_;
  bool by_class_;
};

}  // namespace geom
