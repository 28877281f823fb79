#include <fmt/format.h>

#include <cmath>

#include "../cloud/ply_file.h"
#include "geom/base/text_stream.h"
#include "geom/cloud/cloud_format.h"
#include "geom/model/model.h"
#include "geom/model/model_format.h"
#include "geom/model/model_polygons.h"

namespace geom {
namespace {

class PlyModel {
 public:
  PlyModel(std::istream& in, std::string_view source) : file_(in, source) { model_.parts = {""}; }

  Model read() {
    bool vertices = false;
    for (const PlyElement& element : file_.elements()) {
      if (element.name == "vertex") {
        if (vertices) file_.refuse({.expected = "one element \"vertex\"", .found = "another"});
        read_vertices(element);
        vertices = true;
      } else if (element.name == "face" || element.name == "tristrips") {
        if (!vertices) file_.refuse({.expected = "vertices before the faces"});
        read_faces(element);
      } else {
        file_.for_each_row(element, [](const PlyRow&, std::uint64_t) {});
        if (element.holds_indices() || element.holds_places()) {
          model_.skipped.add("element " + element.name.substr(0, 40),
                             fmt::format("{} of them", element.count));
        }
      }
    }
    file_.require_end();
    if (!vertices) file_.refuse({.expected = "an element \"vertex\"", .found = "none"});
    polygons_.finish(model_);
    return std::move(model_);
  }

 private:
  void read_vertices(const PlyElement& element) {
    const auto x = element.find("x", false);
    const auto y = element.find("y", false);
    const auto z = element.find("z", false);
    if (!x || !y || !z) {
      file_.refuse({.expected = "the properties x, y and z of element \"vertex\"",
                    .found = "not all of them"});
    }
    file_.for_each_row(element, [&](const PlyRow& row, std::uint64_t i) {
      const Vec3 v(row.of(*x)[0], row.of(*y)[0], row.of(*z)[0]);
      if (!v.allFinite() || v.cwiseAbs().maxCoeff() > kLargestCoordinate) {
        file_.refuse({.item = fmt::format("vertex {}", i),
                      .expected = fmt::format("coordinates within {}", kLargestCoordinate),
                      .found = fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z())});
      }
      model_.mesh.vertices.push_back(v);
    });
  }

  void read_faces(const PlyElement& element) {
    const auto corners = element.find("vertex_indices", true);
    const auto other = element.find("vertex_index", true);
    if (corners && other) {
      file_.refuse(
          {.expected = "one list of vertices", .found = "vertex_indices and vertex_index"});
    }
    if (!corners && !other) {
      if (element.count > 0) {
        file_.refuse({.expected = fmt::format("the list vertex_indices of {}", element.name),
                      .found = "none"});
      }
      return;
    }
    const bool strips = element.name == "tristrips";
    file_.for_each_row(element, [&](const PlyRow& row, std::uint64_t i) {
      const std::span<const double> list = row.of(corners ? *corners : *other);
      if (strips) {
        add_strips(list, i);
      } else {
        add_face(list, i);
      }
    });
  }

  std::uint32_t vertex(double v, const char* of, std::uint64_t i) const {
    const auto count = static_cast<double>(model_.mesh.vertices.size());
    if (!(v >= 0 && v < count && v == std::floor(v)) || v > 0xffffffff) {
      file_.refuse({.item = fmt::format("{} {}", of, i),
                    .expected = fmt::format("the numbers of {} vertices", count),
                    .found = fmt::to_string(v)});
    }
    return static_cast<std::uint32_t>(v);
  }

  void add_face(std::span<const double> face, std::uint64_t i) {
    if (face.size() < 3) {
      file_.refuse({.item = fmt::format("face {}", i),
                    .expected = "at least 3 vertices",
                    .found = fmt::to_string(face.size())});
    }
    std::vector<std::uint32_t> index;
    for (const double v : face) index.push_back(vertex(v, "face", i));
    polygons_.add(model_, index, 0);
  }

  // Each vertex makes a triangle with the two before it, turned the other way each time; -1 begins
  // a new strip.
  void add_strips(std::span<const double> list, std::uint64_t i) {
    std::vector<std::uint32_t> strip;
    for (const double v : list) {
      if (v == -1) {
        strip.clear();
        continue;
      }
      strip.push_back(vertex(v, "strip", i));
      const std::size_t n = strip.size();
      if (n < 3) continue;
      const std::size_t odd = n % 2 == 0;
      model_.mesh.triangles.push_back({{strip[n - 3 + odd], strip[n - 2 - odd], strip[n - 1]}, 0});
    }
  }

  PlyFile file_;
  Model model_;
  ModelPolygons polygons_;
};

}  // namespace

Model read_ply_model(std::istream& in, std::string_view source) {
  return PlyModel(in, source).read();
}

namespace {

LoadedModel load_ply(const ModelFile& file) {
  TextInput in(file.bytes);
  return {read_ply_model(in, file.path)};
}

}  // namespace

constinit const ModelFormat kPlyModel{.format = &kPlyFile, .ending = ".ply", .read = load_ply};

}  // namespace geom
