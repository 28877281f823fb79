#pragma once

// What the objects of a GML document are drawn with, before links are followed.

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "geom/import/city_model.h"
#include "gml_geometry.h"

namespace geom::gis {

// A surface of an object, before its links are followed.
struct GmlDrawn {
  std::size_t object;
  CityGeometry geometry;
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

  // Where both are there.
  Eigen::Matrix4d place() const {
    Eigen::Matrix4d out =
        Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(matrix->data());
    out.topRightCorner<3, 1>() += Eigen::Map<const Eigen::Vector3d>(at->data());
    return out;
  }
};

}  // namespace geom::gis
