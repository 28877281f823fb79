#include <cstring>

#include "fuzz/reader.h"
#include "geom/mesh/triangle_cover.h"

namespace {

// A slack and a fill, then vertices as floats, three for each triangle: every corner is covered.
void triangle_cover(std::istream& in) {
  const std::string bytes = fuzz::rest_of(in);
  if (bytes.size() < 5) return;
  float numbers[9];
  std::memcpy(numbers, bytes.data(), 4);
  geom::TriangleCoverOptions options;
  options.slack = numbers[0];
  options.most_pieces = 1e5;
  options.fill = static_cast<geom::SolidFill>(static_cast<unsigned char>(bytes[4]) % 3);
  options.down_to = {0};
  geom::TriangleMesh mesh;
  for (std::size_t at = 5; at + 36 <= bytes.size() && at < 2000; at += 36) {
    std::memcpy(numbers, bytes.data() + at, 36);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int i = 0; i < 9; i += 3)
      mesh.vertices.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
    mesh.triangles.push_back({{first, first + 1, first + 2}, 0});
  }
  const geom::TriangleCover made = geom::cover_triangles(mesh, options);
  for (const geom::Vec3& v : mesh.vertices) {
    bool held = false;
    for (const geom::Aabb& box : made.boxes) held = held || geom::contains(box, v);
    if (!held) __builtin_trap();
  }
}

}  // namespace

std::vector<fuzz::Reader> fuzz::readers() { return {{"triangle_cover", triangle_cover}}; }
