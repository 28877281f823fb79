#pragma once

// What the objects of a GML document are drawn with, before links are followed.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "geom/import/city_model.h"
#include "gml_geometry.h"

namespace footprints {

// A surface of an object, before its links are followed.
struct GmlDrawn {
  std::size_t object;
  geom::CityGeometry geometry;
  GmlShapes::Index shape = 0;
  std::optional<Eigen::Matrix4d> place;
};

// The shape that an ImplicitGeometry places.
struct GmlImplicit {
  GmlShapes::Index shape = 0;
  bool elsewhere = false;  // in a file of its own
  bool drawn = false;
  std::optional<std::vector<double>> matrix;
  std::optional<std::vector<double>> at;
};

}  // namespace footprints
