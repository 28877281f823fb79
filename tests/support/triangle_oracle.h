#pragma once

// What a cover of triangles promises, tried in other ways than it is made.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <span>
#include <vector>

#include "geom/map/box_index.h"
#include "geom/mesh/triangle_mesh.h"

namespace oracle {

using geom::Aabb;
using geom::TriangleMesh;
using geom::Vec3;
using Wide = Eigen::Matrix<long double, 3, 1>;
using WideTriangle = std::array<Wide, 3>;

inline WideTriangle wide(const TriangleMesh& mesh, std::size_t t) {
  WideTriangle out;
  for (std::size_t i = 0; i < 3; ++i) {
    out[i] = mesh.vertices[mesh.triangles[t].corners[i]].cast<long double>();
  }
  return out;
}

inline long double distance_to_segment(const Wide& p, const Wide& a, const Wide& b) {
  const Wide d = b - a;
  const long double square = d.squaredNorm();
  const long double share = square > 0 ? std::clamp((p - a).dot(d) / square, 0.0L, 1.0L) : 0;
  return (a + share * d - p).norm();
}

inline long double distance(const Wide& p, const WideTriangle& t) {
  const auto& [a, b, c] = t;
  const Wide n = (b - a).cross(c - a);
  const long double size = n.norm();
  const bool above = size > 0 && (b - a).cross(p - a).dot(n) >= 0 &&
                     (c - b).cross(p - b).dot(n) >= 0 && (a - c).cross(p - c).dot(n) >= 0;
  if (above) return std::abs((p - a).dot(n)) / size;
  return std::min(
      {distance_to_segment(p, a, b), distance_to_segment(p, b, c), distance_to_segment(p, c, a)});
}

// How often a closed surface winds around the point: the solid angles of its triangles (van
// Oosterom and Strackee, 1983). Off the surface it is near a whole number.
inline long double winding(const Wide& p, std::span<const WideTriangle> triangles) {
  long double angle = 0;
  for (const auto& [a0, b0, c0] : triangles) {
    const Wide a = a0 - p;
    const Wide b = b0 - p;
    const Wide c = c0 - p;
    const long double la = a.norm();
    const long double lb = b.norm();
    const long double lc = c.norm();
    angle += 2 * std::atan2(a.dot(b.cross(c)),
                            la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return angle / (4 * std::numbers::pi_v<long double>);
}

// The distance to some triangles and, besides, to what `solid` says is solid.
struct Body {
  std::vector<WideTriangle> triangles;
  std::function<bool(const Wide&)> solid = [](const Wide&) { return false; };

  explicit Body(const TriangleMesh& mesh) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) triangles.push_back(wide(mesh, t));
  }

  // Filled inside, as one closed surface.
  void fill() {
    solid = [this](const Wide& p) { return std::abs(winding(p, triangles)) > 0.5L; };
  }

  long double distance(const Wide& p) const {
    if (solid(p)) return 0;
    long double least = 1e30L;
    for (const WideTriangle& t : triangles) least = std::min(least, oracle::distance(p, t));
    return least;
  }
};

// Whether no point of the box is further from the body than `slack`: distance grows no faster than
// one goes, so a piece whose middle is near enough is proved as a whole. `most` halvings.
inline bool within_slack(const Body& body, const Aabb& box, double slack, int most = 60) {
  const Wide middle = (box.min.cast<long double>() + box.max.cast<long double>()) / 2;
  const long double half = (box.max - box.min).cast<long double>().norm() / 2;
  const long double away = body.distance(middle);
  if (away + half <= slack) return true;
  if (away > slack || most == 0) return false;
  int axis = 0;
  (box.max - box.min).maxCoeff(&axis);
  Aabb low = box;
  Aabb high = box;
  low.max[axis] = high.min[axis] = 0.5 * (box.min[axis] + box.max[axis]);
  return within_slack(body, low, slack, most - 1) && within_slack(body, high, slack, most - 1);
}

// Which boxes hold a point.
class Holding {
 public:
  explicit Holding(const std::vector<Aabb>& boxes)
      : boxes_(boxes), index_(geom::index_cell(boxes)) {
    for (std::size_t i = 0; i < boxes.size(); ++i) index_.add(i, boxes[i]);
  }

  bool operator()(const Vec3& p) const {
    for (const std::size_t i : index_.near({p, p})) {
      if (geom::contains(boxes_[i], p)) return true;
    }
    return false;
  }

 private:
  const std::vector<Aabb>& boxes_;
  geom::BoxIndex index_;
};

}  // namespace oracle
