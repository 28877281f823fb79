#include "path/taut.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "path/flat_chain.h"

namespace plan {
namespace {

using geom::Polyline;

constexpr double kOff = 1e-3;    // metres that bends keep from boxes
constexpr double kLeast = 1e-9;  // metres: gains below it are rounding
constexpr int kHalvings = 5;     // of a slide that is blocked

// A triangle over its base, which is longer than nothing, and not flat.
struct Triangle {
  Triangle(const Vec3& start, const Vec3& v, const Vec3& end)
      : a(start), c(end), around{a.cwiseMin(v).cwiseMin(c), a.cwiseMax(v).cwiseMax(c)} {
    const Vec3 base = c - a;
    length = base.norm();
    along = base / length;
    up = (v - a) - (v - a).dot(along) * along;
    height = up.norm();
    up /= height;
    normal = along.cross(up);
    tip = (v - a).dot(along);
  }

  // Above its base and below both sides.
  bool holds(double u, double w) const {
    return w > 0 && w * tip <= height * u && w * (length - tip) <= height * (length - u);
  }

  Vec3 a;
  Vec3 c;
  geom::Aabb around;
  double length;  // of the base, from a to c
  double height;  // of the tip over it
  double tip;     // where that is along the base
  Vec3 along;     // unit vectors: of the base, up to the tip, and across
  Vec3 up;
  Vec3 normal;
};

// False only where a box of these grown half sizes around `middle` has no edge, kOff outside it,
// through the triangle: seen along the base, upwards or across, they are apart.
bool may_meet(const Triangle& triangle, const Vec3& middle, const Vec3& half) {
  constexpr double kSpare = 2 * kOff;
  const Vec3 from_a = middle - triangle.a;
  const auto apart = [&](const Vec3& axis, double low, double high) {
    const double at = axis.dot(from_a);
    const double reach = axis.cwiseAbs().dot(half) + kSpare;
    return at + reach < low || at - reach > high;
  };
  return !apart(triangle.normal, 0, 0) && !apart(triangle.up, 0, triangle.height) &&
         !apart(triangle.along, std::min(0.0, triangle.tip),
                std::max(triangle.length, triangle.tip));
}

// The boxes that come near the triangle, ascending: sought in pieces of it, since a box around a
// long one holds much else.
std::vector<std::size_t> boxes_near(const geom::CollisionScene& scene, const Triangle& triangle) {
  constexpr double kPiece = 64;  // metres
  const double pieces = std::ceil(triangle.length / kPiece);
  if (pieces < 2 || triangle.tip < 0 || triangle.tip > triangle.length) {
    return scene.boxes_meeting(triangle.around);
  }
  std::vector<std::size_t> near;
  for (double n = 0; n < pieces; ++n) {
    const double ends[] = {triangle.length * (n / pieces), triangle.length * ((n + 1) / pieces)};
    const double top = triangle.height *
                       std::min({1.0, ends[1] / triangle.tip,
                                 (triangle.length - ends[0]) / (triangle.length - triangle.tip)});
    const Vec3 low = triangle.a + ends[0] * triangle.along;
    const Vec3 high = triangle.a + ends[1] * triangle.along;
    const Vec3 rise = top * triangle.up;
    const geom::Aabb piece{low.cwiseMin(high) + rise.cwiseMin(0),
                           low.cwiseMax(high) + rise.cwiseMax(0)};
    const auto boxes = scene.boxes_meeting(geom::grow(piece, Vec3::Constant(2 * kOff)));
    near.insert(near.end(), boxes.begin(), boxes.end());
  }
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  return near;
}

// Where the edges of the boxes, kOff outside them, pass through the triangle.
std::vector<Flat> edge_points(const geom::CollisionScene& scene, const Triangle& triangle) {
  std::vector<Flat> out;
  for (const std::size_t i : boxes_near(scene, triangle)) {
    const geom::Aabb& obstacle = scene.map().box(i);
    if (!may_meet(triangle, 0.5 * (obstacle.min + obstacle.max),
                  0.5 * (obstacle.max - obstacle.min) + scene.half())) {
      continue;
    }
    geom::Aabb box = scene.grown(i);
    if (!geom::overlap(box, triangle.around)) continue;
    box.min.array() -= kOff;
    box.max.array() += kOff;
    for_edges_through(box, triangle.a, triangle.normal, [&](const Vec3& p) {
      const double u = (p - triangle.a).dot(triangle.along);
      const double w = (p - triangle.a).dot(triangle.up);
      if (triangle.holds(u, w)) out.push_back({u, w, p});
    });
  }
  return out;
}

// The upper convex chain over the base, without its ends.
std::vector<Vec3> chain(std::vector<Flat> points, double length) {
  const auto hull = upper_chain(std::move(points), {0, 0, {}}, {length, 0, {}});
  std::vector<Vec3> out;
  for (std::size_t i = 1; i + 1 < hull.size(); ++i) out.push_back(hull[i].point);
  return out;
}

// scene.free() for a bend that slides. Most of its legs are blocked, and by the boxes that it bends
// around, which are asked first.
class Beside {
 public:
  Beside(const geom::CollisionScene& scene, const Vec3& bend) : scene_(scene), bend_(bend) {}

  bool free(const Vec3& a, const Vec3& b) {
    for (const geom::Aabb& box : boxes_) {
      if (geom::segment_hits(a, b, box)) return false;
    }
    if (scene_.free(a, b)) return true;
    if (boxes_.empty()) look();
    return false;
  }

 private:
  void look() {
    const Vec3 off = Vec3::Constant(2 * kOff);
    for (const std::size_t i : scene_.boxes_meeting({bend_ - off, bend_ + off})) {
      boxes_.push_back(scene_.grown(i));
    }
  }

  const geom::CollisionScene& scene_;
  Vec3 bend_;
  std::vector<geom::Aabb> boxes_;  // once a leg was blocked
};

class Pull {
 public:
  Pull(const geom::CollisionScene& scene, Polyline path)
      : scene_(scene), path_(std::move(path)), touched_(path_.size(), 1) {}

  // Every bend that something changed around, once. Returns metres gained.
  double round() {
    double gained = 0;
    for (std::size_t i = 1; i + 1 < path_.size();) {
      if (!touched_[i]) {
        ++i;
        continue;
      }
      touched_[i] = 0;
      const std::size_t before = path_.size();
      gained += tighten(i);
      if (path_.size() < before) {
        i = std::max<std::size_t>(1, i - 1);
        continue;
      }
      gained += slide(i);
      ++i;
    }
    return gained;
  }

  Polyline take() { return std::move(path_); }

 private:
  void touch_around(std::size_t first, std::size_t last) {
    for (std::size_t k = first > 1 ? first - 1 : 1; k <= last + 1 && k + 1 < path_.size(); ++k) {
      touched_[k] = 1;
    }
  }

  // Replaces bend i by the chain around what is in its triangle.
  double tighten(std::size_t i) {
    const Vec3 a = path_[i - 1];
    const Vec3 v = path_[i];
    const Vec3 c = path_[i + 1];
    const double base = (c - a).norm();
    const double old = (v - a).norm() + (c - v).norm();
    if (old - base < kLeast) return replace(i, {}, old);
    if (base < 1e-6 || (v - a).cross(c - a).norm() < 1e-9 * base) return 0;
    return replace(i, chain(edge_points(scene_, {a, v, c}), base), old);
  }

  double replace(std::size_t i, const std::vector<Vec3>& bends, double old) {
    Polyline legs = {path_[i - 1]};
    legs.insert(legs.end(), bends.begin(), bends.end());
    legs.push_back(path_[i + 1]);
    const double gained = old - geom::length(legs);
    if (gained < (bends.empty() ? -kLeast : kLeast)) return 0;
    for (std::size_t k = 1; k < legs.size(); ++k) {
      if (!scene_.free(legs[k - 1], legs[k])) return 0;
    }
    const auto at = static_cast<std::ptrdiff_t>(i);
    path_.erase(path_.begin() + at);
    touched_.erase(touched_.begin() + at);
    path_.insert(path_.begin() + at, bends.begin(), bends.end());
    touched_.insert(touched_.begin() + at, bends.size(), 0);
    touch_around(i, i + bends.size());
    for (std::size_t k = 0; k < bends.size(); ++k) touched_[i + k] = gained > 1e-6;
    return std::max(0.0, gained);
  }

  // Moves bend i along an axis to where the two legs, unfolded around that line, are straight.
  double slide(std::size_t i) {
    double gained = 0;
    Beside beside(scene_, path_[i]);
    for (int k = 0; k < 3; ++k) {
      const Vec3& a = path_[i - 1];
      const Vec3& c = path_[i + 1];
      const Vec3 v = path_[i];
      const auto aside = [&](const Vec3& p) {
        Vec3 d = p - v;
        d[k] = 0;
        return d.norm();
      };
      const double da = aside(a);
      const double dc = aside(c);
      if (!(da + dc > 1e-9)) continue;
      double step = (a[k] * dc + c[k] * da) / (da + dc) - v[k];
      const double old = (v - a).norm() + (c - v).norm();
      for (int half = 0; half < kHalvings; ++half, step /= 2) {
        Vec3 moved = v;
        moved[k] += step;
        const double gain = old - (moved - a).norm() - (c - moved).norm();
        if (gain < kLeast) break;
        if (!beside.free(a, moved) || !beside.free(moved, c)) continue;
        path_[i] = moved;
        if (gain > 1e-6) touch_around(i, i);
        gained += gain;
        break;
      }
    }
    return gained;
  }

  const geom::CollisionScene& scene_;
  Polyline path_;
  std::vector<char> touched_;  // bends around which something changed
};

}  // namespace

Polyline taut(const geom::CollisionScene& scene, const Polyline& path, const TautOptions& options) {
  if (path.size() < 3) return path;
  Pull pull(scene, path);
  for (int i = 0; i < options.rounds; ++i) {
    if (pull.round() < options.gain) break;
  }
  return pull.take();
}

}  // namespace plan
