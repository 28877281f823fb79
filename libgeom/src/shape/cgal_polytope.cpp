#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include <algorithm>
#include <optional>

#include "geom/shape/polytope.h"

namespace geom {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Point = Kernel::Point_3;
using Number = Kernel::FT;

// normal.dot(x) - offset <= 0 is CGAL's negative side.
Kernel::Plane_3 exact(const Plane& p) {
  return {p.normal.x(), p.normal.y(), p.normal.z(), -p.offset};
}

std::optional<Point> meeting(const Kernel::Plane_3& a, const Kernel::Plane_3& b,
                             const Kernel::Plane_3& c) {
  const Number across =
      CGAL::determinant(a.a(), a.b(), a.c(), b.a(), b.b(), b.c(), c.a(), c.b(), c.c());
  if (CGAL::is_zero(across)) return std::nullopt;
  const auto along = [&](auto first, auto second) {
    return -CGAL::determinant((a.*first)(), (a.*second)(), a.d(), (b.*first)(), (b.*second)(),
                              b.d(), (c.*first)(), (c.*second)(), c.d()) /
           across;
  };
  using P = Kernel::Plane_3;
  return Point(along(&P::b, &P::c), along(&P::c, &P::a), along(&P::a, &P::b));
}

class Region {
 public:
  explicit Region(std::span<const Plane> planes) {
    for (const Plane& p : planes) {
      const Kernel::Plane_3 plane = exact(p);
      if (std::find(planes_.begin(), planes_.end(), plane) == planes_.end()) {
        planes_.push_back(plane);
      }
    }
    for (std::size_t i = 0; i < planes_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (std::size_t k = 0; k < j; ++k) add_vertex(i, j, k);
      }
    }
  }

  Polytope result() const {
    Polytope out;
    for (const Point& p : vertices_) {
      out.vertices.emplace_back(CGAL::to_double(p.x()), CGAL::to_double(p.y()),
                                CGAL::to_double(p.z()));
    }
    for (const Kernel::Plane_3& plane : planes_) {
      auto face = face_on(plane);
      if (face.size() >= 3) out.faces.push_back(std::move(face));
    }
    if (out.faces.size() < 4) out.faces.clear();  // flat
    return out;
  }

 private:
  void add_vertex(std::size_t i, std::size_t j, std::size_t k) {
    const auto p = meeting(planes_[i], planes_[j], planes_[k]);
    if (!p) return;
    for (const Kernel::Plane_3& plane : planes_) {
      if (plane.has_on_positive_side(*p)) return;
    }
    if (std::find(vertices_.begin(), vertices_.end(), *p) == vertices_.end()) {
      vertices_.push_back(*p);
    }
  }

  // Counterclockwise around the outward normal: all turn the same way seen from the first, as the
  // face is convex.
  std::vector<std::uint32_t> face_on(const Kernel::Plane_3& plane) const {
    std::vector<std::uint32_t> face;
    for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
      if (plane.has_on(vertices_[v])) face.push_back(v);
    }
    if (face.size() < 3) return face;
    const Point& first = vertices_[face[0]];
    const Point above = first + plane.orthogonal_vector();
    std::sort(face.begin() + 1, face.end(), [&](std::uint32_t a, std::uint32_t b) {
      return CGAL::orientation(first, vertices_[a], vertices_[b], above) == CGAL::POSITIVE;
    });
    return face;
  }

  std::vector<Kernel::Plane_3> planes_;
  std::vector<Point> vertices_;
};

}  // namespace

Polytope polytope(std::span<const Plane> planes) { return Region(planes).result(); }

}  // namespace geom
