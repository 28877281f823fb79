#pragma once

// The <geometry> of SDF as boxes.

#include <optional>
#include <string>
#include <vector>

#include "geom/base/skipped.h"
#include "geom/shape/polygon.h"
#include "sdf_meshes.h"
#include "sdf_pose.h"

namespace geom {

struct SdfBoxes {
  std::vector<Aabb> boxes;
  std::optional<double> plane;  // the height of a level plane that faces up
};

class SdfShapes {
 public:
  SdfShapes(double slack, SdfMeshes& meshes, Skipped& skipped)
      : slack_(slack), meshes_(meshes), skipped_(skipped) {}

  // Of the element in the world. A plane gives its rectangle as well. What cannot be built is
  // skipped.
  SdfBoxes boxes_of(const SdfNode& geometry, const SdfPose& pose) const;

 private:
  SdfBoxes shape(const SdfNode& shape, const SdfPose& pose) const;
  SdfBoxes box(const SdfNode& shape, const SdfPose& pose) const;
  SdfBoxes plane(const SdfNode& shape, const SdfPose& pose) const;
  struct Extrusion {  // of a polygon, upward from its plane
    Polygon polygon;
    double height = 1;
  };
  std::optional<Extrusion> extrusion(const std::vector<SdfNode>& shapes) const;
  std::vector<Aabb> upright_boxes(Extrusion solid, const SdfPose& pose) const;
  SdfBoxes polylines(const std::vector<SdfNode>& shapes, const SdfPose& pose) const;
  std::vector<Aabb> turned(const struct RingStack& solid, const SdfPose& pose,
                           const SdfNode& at) const;
  void skip(const SdfNode& node, const std::string& kind) const;

  double slack_;
  SdfMeshes& meshes_;
  Skipped& skipped_;
};

}  // namespace geom
