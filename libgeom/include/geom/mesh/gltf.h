#pragma once

// Binary glTF 2.0 (`.glb`): points in single precision, drawn as surfaces and lines.
//
// Example:
//   geom::Gltf gltf(geom::Vec3::Zero());
//   const std::size_t line = gltf.add_positions(
//       path.size(), [&](std::size_t i) { return path[i]; });
//   const std::size_t red = gltf.add_material({.name = "path", .colour = {1, 0, 0}});
//   gltf.add_node("path", {{geom::GltfMode::line_strip, line, std::nullopt, red}});
//   std::ofstream out("path.glb", std::ios::binary);
//   gltf.write(out);

#include <array>
#include <cstddef>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geom/base/vec3.h"

namespace geom {

class JsonLine;

// From east-north-up to glTF's axes: x east, y up, z south.
Vec3 to_gltf(const Vec3& enu);

using Rgb = std::array<double, 3>;  // each 0 to 1

struct GltfMaterial {
  std::string name;  // may be empty
  Rgb colour{};
  double opacity = 1;           // below 1 what is behind shines through
  std::optional<Rgb> emissive;  // of lines that no light falls on
};

// As glTF numbers them.
enum class GltfMode { lines = 1, line_strip = 3, triangles = 4 };

// Points drawn in one way; the numbers are those that Gltf's functions gave.
struct GltfPrimitive {
  GltfMode mode = GltfMode::triangles;
  std::size_t positions = 0;
  std::optional<std::size_t> indices;  // none: the points in their order
  std::size_t material = 0;
};

// One scene, put together part by part and then written. Each function that adds something returns
// its number. Throws InputError where more is added or written than the format's 4 GB.
class Gltf {
 public:
  // Positions are kept relative to `origin` (ENU), which becomes the translation of every node.
  explicit Gltf(const Vec3& origin) : origin_(origin) {}

  // `enu` and `at` are asked from 0 on, once each, in order.
  std::size_t add_positions(std::size_t count, const std::function<Vec3(std::size_t)>& enu);
  std::size_t add_indices(std::size_t count, const std::function<std::size_t(std::size_t)>& at);
  std::size_t add_material(GltfMaterial material);
  void add_node(std::string name, std::vector<GltfPrimitive> primitives);

  // `note` goes with the file where it is not empty. A file without nodes is an empty scene.
  void write(std::ostream& out, std::string_view note = {}) const;

 private:
  struct Array {  // an accessor, and the view of the buffer that it alone reads
    std::size_t begin;
    std::size_t count;
    std::optional<std::array<Eigen::Vector3f, 2>> extent;  // of positions, which are its kind then
  };
  struct Node {
    std::string name;
    std::vector<GltfPrimitive> primitives;
  };

  void require_room(std::size_t bytes) const;
  std::string json(std::string_view note) const;
  JsonLine accessor(std::size_t array) const;
  JsonLine view(std::size_t array) const;

  Vec3 origin_;
  std::string bin_;
  std::vector<Array> arrays_;
  std::vector<GltfMaterial> materials_;
  std::vector<Node> nodes_;
};

}  // namespace geom
