#include "triangle_groups.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

namespace geom {
namespace {

constexpr auto kNone = std::numeric_limits<std::uint32_t>::max();

// Of each vertex, the first that has its coordinates (-0 is 0).
std::vector<std::uint32_t> first_equal(const std::vector<Vec3>& vertices) {
  const auto key = [&](std::uint32_t i) {
    const Vec3& v = vertices[i];
    return std::tuple(v.x(), v.y(), v.z());
  };
  std::vector<std::uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t k) {
    if (key(i) != key(k)) return key(i) < key(k);
    return i < k;
  });
  std::vector<std::uint32_t> out(vertices.size());
  for (std::size_t n = 0; n < order.size(); ++n) {
    const bool same = n > 0 && key(order[n]) == key(order[n - 1]);
    out[order[n]] = same ? out[order[n - 1]] : order[n];
  }
  return out;
}

// Sets of triangles that are joined one by one; a set is known by its lowest.
class JoinedSets {
 public:
  explicit JoinedSets(std::size_t n) : above_(n) { std::iota(above_.begin(), above_.end(), 0u); }

  std::uint32_t set_of(std::uint32_t i) {
    while (above_[i] != i) i = above_[i] = above_[above_[i]];
    return i;
  }
  void join(std::uint32_t i, std::uint32_t k) {
    const auto [low, high] = std::minmax({set_of(i), set_of(k)});
    above_[high] = low;
  }

 private:
  std::vector<std::uint32_t> above_;
};

struct Edge {
  std::uint32_t part;
  std::uint32_t low;  // vertices
  std::uint32_t high;
  std::uint32_t triangle;
  bool up;  // gone along from low to high

  auto key() const { return std::tuple(part, low, high); }
};

// Edges between different vertices, the same ones behind each other.
std::vector<Edge> sorted_edges(const TriangleMesh& mesh) {
  const std::vector<std::uint32_t> vertex = first_equal(mesh.vertices);
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const MeshTriangle& triangle = mesh.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = vertex[triangle.corners[i]];
      const std::uint32_t b = vertex[triangle.corners[(i + 1) % 3]];
      if (a == b) continue;
      edges.push_back(
          {triangle.part, std::min(a, b), std::max(a, b), static_cast<std::uint32_t>(t), a < b});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    if (a.key() != b.key()) return a.key() < b.key();
    return a.triangle < b.triangle;
  });
  return edges;
}

// Surfaces, each known by its lowest triangle.
struct Surfaces {
  std::vector<std::uint32_t> of;  // of each triangle
  std::vector<char> closed;       // at the lowest triangle of a surface
};

Surfaces surfaces_of(const TriangleMesh& mesh) {
  const std::vector<Edge> edges = sorted_edges(mesh);
  const std::size_t n = mesh.triangles.size();
  JoinedSets sets(n);
  std::vector<char> torn(n, 0);
  for (std::size_t first = 0, last; first < edges.size(); first = last) {
    long balance = 0;
    for (last = first; last < edges.size() && edges[last].key() == edges[first].key(); ++last) {
      balance += edges[last].up ? 1 : -1;
      sets.join(edges[first].triangle, edges[last].triangle);
    }
    if (balance != 0) torn[edges[first].triangle] = 1;
  }
  Surfaces out;
  out.of.resize(n);
  std::vector<std::size_t> count(n, 0);
  std::vector<char> open(n, 0);
  for (std::uint32_t t = 0; t < n; ++t) {
    out.of[t] = sets.set_of(t);
    ++count[out.of[t]];
    if (torn[t]) open[out.of[t]] = 1;
  }
  out.closed.resize(n);
  for (std::size_t t = 0; t < n; ++t) out.closed[t] = count[t] >= 4 && !open[t];
  return out;
}

// Triangles of one `group` number together, in the order of the first of each.
TriangleGroups grouped(const TriangleMesh& mesh, const std::vector<std::uint32_t>& group,
                       std::size_t groups) {
  TriangleGroups out;
  std::vector<std::uint32_t> place(groups, kNone);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::uint32_t& at = place[group[t]];
    if (at == kNone) {
      at = static_cast<std::uint32_t>(out.groups.size());
      out.groups.push_back({0, 0, mesh.triangles[t].part, false});
    }
    ++out.groups[at].count;
  }
  std::size_t first = 0;
  for (TriangleGroup& g : out.groups) {
    g.first = first;
    first += g.count;
    g.count = 0;
  }
  out.triangles.resize(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    TriangleGroup& g = out.groups[place[group[t]]];
    out.triangles[g.first + g.count++] = static_cast<std::uint32_t>(t);
  }
  return out;
}

std::size_t part_count(const TriangleMesh& mesh) {
  std::size_t parts = 0;
  for (const MeshTriangle& t : mesh.triangles) parts = std::max<std::size_t>(parts, t.part + 1u);
  return parts;
}

}  // namespace

TriangleGroups groups_by_part(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> group(mesh.triangles.size());
  for (std::size_t t = 0; t < group.size(); ++t) group[t] = mesh.triangles[t].part;
  return grouped(mesh, group, part_count(mesh));
}

TriangleGroups groups_by_surface(const TriangleMesh& mesh) {
  const Surfaces surfaces = surfaces_of(mesh);
  const std::size_t parts = part_count(mesh);
  const std::size_t n = mesh.triangles.size();
  std::vector<std::uint32_t> group(n);
  std::size_t open = 0;
  for (std::size_t t = 0; t < n; ++t) {
    const std::uint32_t surface = surfaces.of[t];
    const bool closed = surfaces.closed[surface] != 0;
    open += !closed && surface == t;
    group[t] = closed ? static_cast<std::uint32_t>(parts) + surface : mesh.triangles[t].part;
  }
  TriangleGroups out = grouped(mesh, group, parts + n);
  for (TriangleGroup& g : out.groups) {
    g.closed = surfaces.closed[surfaces.of[out.triangles[g.first]]] != 0;
  }
  out.open_surfaces = open;
  return out;
}

}  // namespace geom
