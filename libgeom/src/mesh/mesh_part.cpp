#include <Eigen/Geometry>
#include <cmath>
#include <memory>

#include "geom/map/label_colour.h"
#include "geom/mesh/mesh.h"

namespace geom {
namespace {

using Triangle = std::array<std::size_t, 3>;

// Corner i has the upper x where bit 0 is set, y for bit 1, z for bit 2; counter-clockwise from
// outside in right-handed axes.
constexpr std::array<Triangle, 12> kBox = {{{0, 2, 1},
                                            {1, 2, 3},
                                            {4, 5, 6},
                                            {5, 7, 6},
                                            {0, 1, 4},
                                            {1, 5, 4},
                                            {2, 6, 3},
                                            {3, 6, 7},
                                            {0, 4, 2},
                                            {2, 4, 6},
                                            {1, 3, 5},
                                            {3, 7, 5}}};

Vec3 corner(const Aabb& box, std::size_t i) {
  return {i & 1 ? box.max.x() : box.min.x(), i & 2 ? box.max.y() : box.min.y(),
          i & 4 ? box.max.z() : box.min.z()};
}

struct Shape {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
};

// The corners of an octahedron, each face cut into four: `rounds` times.
Shape unit_sphere(int rounds) {
  Shape s;
  for (int axis = 0; axis < 3; ++axis) {
    s.vertices.push_back(Vec3::Unit(axis));
    s.vertices.push_back(-Vec3::Unit(axis));
  }
  for (int k = 0; k < 8; ++k) {  // one face an octant; odd numbers of mirrors turn it round
    const std::size_t x = k & 1;
    const std::size_t y = 2 + (k >> 1 & 1);
    const std::size_t z = 4 + (k >> 2 & 1);
    const bool mirrored = (k & 1) ^ (k >> 1 & 1) ^ (k >> 2 & 1);
    s.triangles.push_back(mirrored ? Triangle{x, z, y} : Triangle{x, y, z});
  }
  for (; rounds > 0; --rounds) {
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : s.triangles) {
      const auto between = [&](std::size_t i, std::size_t j) {
        const Vec3 middle = (s.vertices[i] + s.vertices[j]).normalized();
        for (std::size_t k = 0; k < s.vertices.size(); ++k) {
          if ((s.vertices[k] - middle).norm() < 1e-9) return k;
        }
        s.vertices.push_back(middle);
        return s.vertices.size() - 1;
      };
      const std::size_t ab = between(a, b);
      const std::size_t bc = between(b, c);
      const std::size_t ca = between(c, a);
      for (const Triangle& t :
           {Triangle{a, ab, ca}, Triangle{b, bc, ab}, Triangle{c, ca, bc}, Triangle{ab, bc, ca}}) {
        finer.push_back(t);
      }
    }
    s.triangles = std::move(finer);
  }
  return s;
}

constexpr std::size_t kSides = 8;

// Vertex i of the tube from a to b: even ones around a, odd ones around b.
Vec3 on_tube(const Vec3& a, const Vec3& b, double radius, std::size_t i) {
  const Vec3 along = b - a;
  const Vec3 axis = along.norm() > 0 ? Vec3(along.normalized()) : Vec3(Vec3::UnitZ());
  const Vec3 side = axis.unitOrthogonal();
  const Vec3 up = axis.cross(side);
  const double turn = 2 * 3.141592653589793 * static_cast<double>(i / 2) / kSides;
  return (i % 2 ? b : a) + radius * (std::cos(turn) * side + std::sin(turn) * up);
}

Triangle of_tube(std::size_t i) {
  const std::size_t here = i - i % 2;
  const std::size_t next = (here + 2) % (2 * kSides);
  if (i % 2) return {here + 1, next, next + 1};
  return {here, next, here + 1};
}

}  // namespace

std::vector<MeshPart> box_parts(const BoxMap& map) {
  const Axes axes = map.spec().frame.axes;
  std::vector<MeshPart> parts;
  for (std::uint32_t label = 0; label < map.labels().size(); ++label) {
    auto rows = std::make_shared<std::vector<std::size_t>>();
    for (std::size_t i = 0; i < map.size(); ++i) {
      if (map.label()[i] == label) rows->push_back(i);
    }
    if (rows->empty()) continue;
    const auto boxes = map.boxes();
    const std::string& name = map.labels()[label];
    parts.push_back(
        {name.empty() ? "boxes" : name, label_colour(label, name), 8 * rows->size(),
         12 * rows->size(),
         [=](std::size_t i) { return corner(to_enu(axes, boxes[(*rows)[i / 8]]), i % 8); },
         [](std::size_t i) {
           Triangle t = kBox[i % 12];
           for (std::size_t& k : t) k += 8 * (i / 12);
           return t;
         }});
  }
  return parts;
}

MeshPart rod_part(Rods given) {
  const auto rods = std::make_shared<const Rods>(std::move(given));
  const auto sphere = std::make_shared<const Shape>(unit_sphere(2));
  const std::size_t a = sphere->vertices.size();
  const std::size_t b = sphere->triangles.size();
  const std::size_t points = rods->points.size();
  MeshPart part{rods->name,
                rods->colour,
                points * a + rods->edges.size() * 2 * kSides,
                points * b + rods->edges.size() * 2 * kSides,
                {},
                {}};
  part.vertex = [=](std::size_t i) -> Vec3 {
    if (i < points * a) return rods->points[i / a] + rods->sphere_radius * sphere->vertices[i % a];
    const std::size_t k = i - points * a;
    const auto& [from, to] = rods->edges[k / (2 * kSides)];
    return on_tube(rods->points[from], rods->points[to], rods->radius, k % (2 * kSides));
  };
  part.triangle = [=](std::size_t i) {
    const bool on_sphere = i < points * b;
    const std::size_t k = i - (on_sphere ? 0 : points * b);
    Triangle t = on_sphere ? sphere->triangles[k % b] : of_tube(k % (2 * kSides));
    const std::size_t first = on_sphere ? k / b * a : points * a + k / (2 * kSides) * 2 * kSides;
    for (std::size_t& v : t) v += first;
    return t;
  };
  return part;
}

MeshPart polytope_part(std::string name, std::array<std::uint8_t, 3> colour, Axes axes,
                       std::span<const Polytope> regions) {
  auto vertices = std::make_shared<std::vector<Vec3>>();
  auto triangles = std::make_shared<std::vector<Triangle>>();
  const bool mirrored = axes != Axes::enu;  // turning them into ENU swaps two axes
  for (const Polytope& region : regions) {
    const std::size_t first = vertices->size();
    for (const Vec3& v : region.vertices) vertices->push_back(to_enu(axes, v));
    for (const auto& face : region.faces) {
      for (std::size_t i = 2; i < face.size(); ++i) {
        Triangle t = {first + face[0], first + face[i - 1], first + face[i]};
        if (mirrored) std::swap(t[1], t[2]);
        triangles->push_back(t);
      }
    }
  }
  return {std::move(name),
          colour,
          vertices->size(),
          triangles->size(),
          [=](std::size_t i) { return (*vertices)[i]; },
          [=](std::size_t i) { return (*triangles)[i]; }};
}

}  // namespace geom
