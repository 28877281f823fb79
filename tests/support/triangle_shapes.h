#pragma once

// Surfaces for tests: closed ones face outward.

#include <cmath>
#include <numbers>

#include "geom/mesh/triangle_mesh.h"
#include "geom/shape/aabb.h"
#include "support/random_city.h"

namespace support {

using geom::TriangleMesh;
using geom::Vec3;

inline void add_quad(TriangleMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c,
                     std::uint32_t d, std::uint32_t part = 0) {
  mesh.triangles.push_back({{a, b, c}, part});
  mesh.triangles.push_back({{a, c, d}, part});
}

inline void add(TriangleMesh& mesh, const TriangleMesh& other, std::uint32_t part = 0) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const geom::MeshTriangle& t : other.triangles) {
    mesh.triangles.push_back(
        {{first + t.corners[0], first + t.corners[1], first + t.corners[2]}, part});
  }
}

inline TriangleMesh cuboid(const geom::Aabb& box) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.emplace_back(i & 1 ? box.max.x() : box.min.x(), i & 2 ? box.max.y() : box.min.y(),
                               i & 4 ? box.max.z() : box.min.z());
  }
  add_quad(mesh, 0, 2, 3, 1);
  add_quad(mesh, 4, 5, 7, 6);
  add_quad(mesh, 0, 1, 5, 4);
  add_quad(mesh, 2, 6, 7, 3);
  add_quad(mesh, 0, 4, 6, 2);
  add_quad(mesh, 1, 3, 7, 5);
  return mesh;
}

// Rings of points around a ring (inner radius > 0), or a sphere of poles (ring radius 0).
inline TriangleMesh torus(const Vec3& center, double ring, double tube, std::uint32_t n,
                          std::uint32_t m) {
  TriangleMesh mesh;
  const double turn = 2 * std::numbers::pi;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = 0; k < m; ++k) {
      const double u = turn * i / n;
      const double v = turn * k / m;
      const double r = ring + tube * std::cos(v);
      mesh.vertices.push_back(center + Vec3(r * std::cos(u), r * std::sin(u), tube * std::sin(v)));
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t k = 0; k < m; ++k) {
      const std::uint32_t i1 = (i + 1) % n;
      const std::uint32_t k1 = (k + 1) % m;
      add_quad(mesh, i * m + k, i1 * m + k, i1 * m + k1, i * m + k1);
    }
  }
  return mesh;
}

inline TriangleMesh sphere(const Vec3& center, double radius, std::uint32_t n, std::uint32_t m) {
  TriangleMesh mesh;
  const double pi = std::numbers::pi;
  mesh.vertices.push_back(center - Vec3(0, 0, radius));
  for (std::uint32_t k = 1; k < m; ++k) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const double v = pi * k / m - pi / 2;
      const double u = 2 * pi * i / n;
      mesh.vertices.push_back(center + radius * Vec3(std::cos(v) * std::cos(u),
                                                     std::cos(v) * std::sin(u), std::sin(v)));
    }
  }
  mesh.vertices.push_back(center + Vec3(0, 0, radius));
  const auto at = [&](std::uint32_t k, std::uint32_t i) { return 1 + (k - 1) * n + i % n; };
  const std::uint32_t top = 1 + (m - 1) * n;
  for (std::uint32_t i = 0; i < n; ++i) {
    mesh.triangles.push_back({{0, at(1, i + 1), at(1, i)}, 0});
    mesh.triangles.push_back({{top, at(m - 1, i), at(m - 1, i + 1)}, 0});
    for (std::uint32_t k = 1; k + 1 < m; ++k) {
      add_quad(mesh, at(k, i), at(k, i + 1), at(k + 1, i + 1), at(k + 1, i));
    }
  }
  return mesh;
}

inline TriangleMesh turned_inside_out(TriangleMesh mesh) {
  for (geom::MeshTriangle& t : mesh.triangles) std::swap(t.corners[1], t.corners[2]);
  return mesh;
}

// Vertices are multiples of 2^-10 m within 2^9 m, so that points with weights of 2^-16 are exact.
// Among them are slivers, needles, segments, points, and triangles in planes of whole metres.
inline TriangleMesh soup(std::uint64_t seed, std::size_t count) {
  Random random(seed);
  TriangleMesh mesh;
  const auto snapped = [](double v) { return std::round(v * 1024) / 1024; };
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 at(random.stepped(-20, 20, 0.5), random.stepped(-20, 20, 0.5),
                  random.stepped(-5, 20, 0.5));
    std::array<Vec3, 3> corners;
    const int kind = random.below(6);
    for (Vec3& v : corners) {
      for (int k = 0; k < 3; ++k) v[k] = snapped(at[k] + random.uniform(-6, 6));
    }
    const int axis = random.below(3);
    if (kind == 1) corners[2] = corners[1] + Vec3::Unit(axis) / 1024;  // needle
    if (kind == 2) corners[2] = corners[0];                            // segment
    if (kind == 3) corners[1] = corners[2] = corners[0];               // point
    if (kind == 4) {
      for (Vec3& v : corners) v[axis] = std::round(at[axis]);  // in a plane
    }
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
    mesh.triangles.push_back({{first, first + 1, first + 2}, static_cast<std::uint32_t>(i % 3)});
  }
  return mesh;
}

// A point of a soup's triangle, exactly.
inline Vec3 exact_point(Random& random, const TriangleMesh& mesh, std::size_t t) {
  std::array<int, 2> cut{random.below(65537), random.below(65537)};
  if (cut[0] > cut[1]) std::swap(cut[0], cut[1]);
  const double a = cut[0] / 65536.0;
  const double b = (cut[1] - cut[0]) / 65536.0;
  const auto& c = mesh.triangles[t].corners;
  return a * mesh.vertices[c[0]] + b * mesh.vertices[c[1]] + (1 - a - b) * mesh.vertices[c[2]];
}

}  // namespace support
