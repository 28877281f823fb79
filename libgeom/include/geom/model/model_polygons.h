#pragma once

// Polygons of models as triangles, and models as boxes.
//
// Example:
//   geom::Model model;
//   model.mesh.vertices = {{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}};
//   geom::ModelPolygons polygons;
//   const std::vector<std::uint32_t> floor = {0, 1, 2, 3};
//   polygons.add(model, floor, 0);
//   polygons.finish(model);
//   assert(model.mesh.triangles.size() == 2);

#include <cstdint>
#include <span>

#include "geom/base/execution.h"
#include "geom/mesh/triangle_cover.h"
#include "geom/model/model.h"

namespace geom {

// Adds polygons to a model. A polygon whose corners lie in one plane is its triangles
// (polygon_triangles), wherever it is cut. One that is bent by more than a millionth of its size is
// another surface for each way to cut it, and files do not say which is meant. So a solid is added
// that holds all of them: the tetrahedron of a quadrangle; of more corners all between the lowest
// and the highest of them, over the polygon as it is seen along one axis. Where it is bent by more
// than a tenth of its size, another axis may show no notch: then it is over the convex hull.
class ModelPolygons {
 public:
  // The polygon of these vertices, at least three.
  void add(Model& model, std::span<const std::uint32_t> corners, std::uint32_t part);

  // To be called once, after the last: adds the solids, as parts of the names of the polygons'.
  void finish(Model& model);

 private:
  void add_tetrahedron(std::span<const Vec3> corners, std::uint32_t part);
  void add_prism(const std::array<Vec3, 3>& low, const std::array<Vec3, 3>& high,
                 std::uint32_t part);

  TriangleMesh solids_;  // closed
  std::size_t bent_ = 0;
};

// cover_triangles() of the model; the solids of bent polygons are filled, whatever `options` say.
TriangleCover cover_model(const Model& model, const TriangleCoverOptions& options,
                          const Execution& run = {});

}  // namespace geom
