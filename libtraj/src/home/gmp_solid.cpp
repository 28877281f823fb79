#include "gmp_solid.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace traj::exact {
namespace {

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Whole dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Extent extent(const std::vector<Point>& points, const Point& normal) {
  Extent out{dot(points.front(), normal), 0};
  out.second = out.first;
  for (const Point& p : points) {
    const Whole at = dot(p, normal);
    if (at < out.first) out.first = at;
    if (at > out.second) out.second = at;
  }
  return out;
}

Extent extent(const WholeBox& box, const Point& normal) {
  Extent out{0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const bool up = normal[i] > 0;
    out.first += normal[i] * (up ? box.low : box.high)[i];
    out.second += normal[i] * (up ? box.high : box.low)[i];
  }
  return out;
}

}  // namespace

Solid::Solid(const Prism& prism, const std::optional<Vec3>& to) {
  for (const Vec3& corner : traj::corners(prism)) corners_.push_back(whole(corner));
  normals_ = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  add_plan_normals(prism);
  if (to) {
    add_normals_to(prism, whole(*to));
    corners_.push_back(whole(*to));
  }
  for (const Point& normal : normals_) extents_.push_back(extent(corners_, normal));
}

void Solid::add_plan_normals(const Prism& prism) {
  const std::size_t count = prism.plan.size();
  for (std::size_t i = 0; i < count && count > 1; ++i) {
    const Point edge = minus(corners_[(i + 1) % count], corners_[i]);
    normals_.push_back({edge[1], -edge[0], 0});
  }
}

// Across the way from each corner, and an edge there or of a box.
void Solid::add_normals_to(const Prism& prism, const Point& to) {
  const std::size_t count = prism.plan.size();
  for (std::size_t i = 0; i < 2 * count; ++i) {
    const std::size_t level = i - i % count;  // of the first corner at this height
    const Point way = minus(to, corners_[i]);
    for (const Point& axis : {Point{1, 0, 0}, Point{0, 1, 0}, Point{0, 0, 1}}) {
      normals_.push_back(cross(way, axis));
    }
    for (const std::size_t next : {(i + 1) % count, (i + count - 1) % count}) {
      if (count > 1) normals_.push_back(cross(way, minus(corners_[level + next], corners_[i])));
    }
  }
}

bool Solid::apart(const WholeBox& box) const {
  for (std::size_t i = 0; i < normals_.size(); ++i) {
    const Extent other = extent(box, normals_[i]);
    if (extents_[i].first > other.second || extents_[i].second < other.first) return true;
  }
  return false;
}

bool Solid::within(const WholeBox& box) const {
  return std::all_of(corners_.begin(), corners_.end(), [&](const Point& p) {
    return p[0] >= box.low[0] && p[1] >= box.low[1] && p[2] >= box.low[2] && p[0] <= box.high[0] &&
           p[1] <= box.high[1] && p[2] <= box.high[2];
  });
}

RoughSolid::RoughSolid(const Prism& prism, const std::optional<Vec3>& to)
    : corners_(traj::corners(prism)) {
  const std::size_t count = prism.plan.size();
  std::vector<Vec3> edges;
  for (std::size_t i = 0; i < count && count > 1; ++i) {
    edges.push_back(corners_[(i + 1) % count] - corners_[i]);
  }
  const std::vector<Vec3> of_prism = corners_;
  if (to) corners_.push_back(*to);
  around_ = *geom::bounds(corners_);
  for (const Vec3& edge : edges) add({edge.y(), -edge.x(), 0});
  if (!to) return;
  // Across the ways to the point: along these faces most boxes that are below, or beside, are
  // apart.
  for (const Vec3& corner : of_prism) {
    const Vec3 way = *to - corner;
    for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY()), Vec3(Vec3::UnitZ())}) {
      add(way.cross(axis));
    }
    for (const Vec3& edge : edges) add(way.cross(edge));
  }
}

void RoughSolid::add(const Vec3& normal) {
  Along one{normal, std::numeric_limits<double>::infinity(),
            -std::numeric_limits<double>::infinity(), 0};
  for (const Vec3& p : corners_) {
    const double at = normal.dot(p);
    one.least = std::min(one.least, at);
    one.most = std::max(one.most, at);
    one.size = std::max(one.size, normal.cwiseAbs().dot(p.cwiseAbs()));
  }
  along_.push_back(one);
}

bool RoughSolid::surely_apart(const geom::Aabb& box) const {
  if (!geom::overlap(around_, box)) return true;
  constexpr double kRounding = 1e-14;  // of a sum of three products, of its size
  const Vec3 far = box.min.cwiseAbs().cwiseMax(box.max.cwiseAbs());
  return std::any_of(along_.begin(), along_.end(), [&](const Along& one) {
    const Vec3 up = one.normal.cwiseMax(0);
    const Vec3 down = one.normal.cwiseMin(0);
    const double least = up.dot(box.min) + down.dot(box.max);
    const double most = up.dot(box.max) + down.dot(box.min);
    const double room = kRounding * (one.size + one.normal.cwiseAbs().dot(far));
    return one.least - most > room || least - one.most > room;
  });
}

}  // namespace traj::exact
