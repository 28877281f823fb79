#include <fmt/format.h>

#include <cmath>

#include "../cloud/ply_file.h"
#include "geom/model/model.h"

namespace geom {
namespace {

class PlyModel {
 public:
  PlyModel(std::istream& in, std::string_view source) : file_(in, source) { model_.parts = {""}; }

  Model read() {
    bool vertices = false;
    for (const PlyElement& element : file_.elements()) {
      if (element.name == "vertex") {
        if (vertices) file_.refuse("expected one element \"vertex\", found another");
        read_vertices(element);
        vertices = true;
      } else if (element.name == "face") {
        if (!vertices) file_.refuse("expected vertices before the faces");
        read_faces(element);
      } else {
        file_.for_each_row(element, [](const PlyRow&, std::uint64_t) {});
        if ((element.name == "edge" || element.name == "tristrips") && element.count > 0) {
          model_.skipped.add("element " + element.name, fmt::format("{} of them", element.count));
        }
      }
    }
    file_.require_end();
    if (!vertices) file_.refuse("expected an element \"vertex\", found none");
    return std::move(model_);
  }

 private:
  void read_vertices(const PlyElement& element) {
    const auto x = element.find("x", false);
    const auto y = element.find("y", false);
    const auto z = element.find("z", false);
    if (!x || !y || !z) {
      file_.refuse(
          "expected the properties x, y and z of element \"vertex\", found not all of them");
    }
    file_.for_each_row(element, [&](const PlyRow& row, std::uint64_t i) {
      const Vec3 v(row.of(*x)[0], row.of(*y)[0], row.of(*z)[0]);
      if (!v.allFinite() || v.cwiseAbs().maxCoeff() > kLargestCoordinate) {
        file_.refuse(fmt::format("vertex {}: expected coordinates within {}, found [{}, {}, {}]", i,
                                 kLargestCoordinate, v.x(), v.y(), v.z()));
      }
      model_.mesh.vertices.push_back(v);
    });
  }

  void read_faces(const PlyElement& element) {
    auto corners = element.find("vertex_indices", true);
    if (!corners) corners = element.find("vertex_index", true);
    if (!corners) {
      if (element.count > 0) file_.refuse("expected the list vertex_indices of faces, found none");
      return;
    }
    file_.for_each_row(element,
                       [&](const PlyRow& row, std::uint64_t i) { add_face(row.of(*corners), i); });
  }

  void add_face(std::span<const double> face, std::uint64_t i) {
    if (face.size() < 3) {
      file_.refuse(fmt::format("face {}: expected at least 3 vertices, found {}", i, face.size()));
    }
    std::vector<std::uint32_t> index;
    std::vector<Vec3> corners;
    for (const double v : face) {
      const auto count = static_cast<double>(model_.mesh.vertices.size());
      if (!(v >= 0 && v < count && v == std::floor(v)) || v > 0xffffffff) {
        file_.refuse(
            fmt::format("face {}: expected the numbers of {} vertices, found {}", i, count, v));
      }
      index.push_back(static_cast<std::uint32_t>(v));
      corners.push_back(model_.mesh.vertices[index.back()]);
    }
    for (const auto& [a, b, c] : polygon_triangles(corners)) {
      model_.mesh.triangles.push_back({{index[a], index[b], index[c]}, 0});
    }
  }

  PlyFile file_;
  Model model_;
};

}  // namespace

Model read_ply_model(std::istream& in, std::string_view source) {
  return PlyModel(in, source).read();
}

}  // namespace geom
