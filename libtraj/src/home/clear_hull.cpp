#include "home/clear_hull.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "geom/base/precondition.h"
#include "geom/shape/hull.h"

namespace traj {
namespace {

using geom::Aabb;
using geom::Vec3;

constexpr double kSure = 1e-9;       // m, for the rounding of what is added to places
constexpr double kShortest = 20;     // m: shorter parts are not cut
constexpr double kPartOverHull = 2;  // parts are cut until they are so long, in sizes of the hull

bool in_bounds(const geom::CollisionScene& scene, std::span<const Vec3> points,
               const std::optional<double>& stands_on) {
  if (!scene.free_bounds()) return false;
  Aabb free = *scene.free_bounds();
  if (stands_on) free.min.z() = -geom::kFarthest;
  return std::all_of(points.begin(), points.end(),
                     [&](const Vec3& p) { return geom::contains(free, p); });
}

// Whether one of the grown boxes that meet `region` meets the hull.
bool meets_in(const geom::CollisionScene& scene, std::span<const Vec3> hull, const Aabb& region,
              const std::optional<double>& stands_on) {
  const Vec3 sure = Vec3::Constant(kSure);
  for (const std::size_t i : scene.boxes_meeting({region.min - sure, region.max + sure})) {
    if (stands_on && scene.map().box(i).max.z() <= *stands_on) continue;
    const Aabb grown = scene.grown(i);
    if (geom::hull_meets(hull, {grown.min - sure, grown.max + sure})) return true;
  }
  return false;
}

// The hull of places and a point, cut across the way from the places' middle to the point.
class Join {
 public:
  Join(const geom::CollisionScene& scene, std::span<const Vec3> from, const Vec3& to,
       const std::optional<double>& stands_on)
      : scene_(scene), from_(*geom::bounds(from)), to_(to), stands_on_(stands_on) {
    hull_.assign(from.begin(), from.end());
    hull_.push_back(to);
    middle_ = 0.5 * (from_.min + from_.max);
    length_ = (to - middle_).norm();
    size_ = (from_.max - from_.min).norm();
    mean_ = std::accumulate(from.begin(), from.end(), Vec3(Vec3::Zero())) /
            static_cast<double>(from.size());
  }

  bool clear() const { return (stands_on_ || !scene_.hits(mean_, to_)) && clear(0, 1); }

 private:
  // The part with shares of the way from `a` to `b`: at a share s it is the places, made smaller
  // by 1 - s about the point.
  bool clear(double a, double b) const {
    if (!stands_on_ && !scene_.sweep_hits(at(a), at(b), scene_.half() + half_at(a))) return true;
    const double size = (1 - a) * size_;
    if ((b - a) * length_ <= std::max(kShortest, kPartOverHull * size)) {
      return !meets_in(scene_, hull_, geom::merged(box_at(a), box_at(b)), stands_on_);
    }
    const double middle = 0.5 * (a + b);
    return clear(a, middle) && clear(middle, b);
  }

  Vec3 at(double share) const { return middle_ + share * (to_ - middle_); }
  Vec3 half_at(double share) const {
    return 0.5 * (1 - share) * (from_.max - from_.min) + Vec3::Constant(2 * kSure);
  }
  Aabb box_at(double share) const {
    return {at(share) - half_at(share), at(share) + half_at(share)};
  }

  const geom::CollisionScene& scene_;
  Aabb from_;
  Vec3 to_;
  const std::optional<double>& stands_on_;
  std::vector<Vec3> hull_;
  Vec3 middle_ = Vec3::Zero();
  Vec3 mean_ = Vec3::Zero();  // in the hull
  double length_ = 0;
  double size_ = 0;
};

}  // namespace

bool clear_hull(const geom::CollisionScene& scene, std::span<const Vec3> hull,
                const std::optional<double>& stands_on) {
  return in_bounds(scene, hull, stands_on) &&
         !meets_in(scene, hull, *geom::bounds(hull), stands_on);
}

bool clear_join(const geom::CollisionScene& scene, std::span<const Vec3> from, const Vec3& to,
                const std::optional<double>& stands_on) {
  if (!in_bounds(scene, from, stands_on) || !in_bounds(scene, {&to, 1}, stands_on)) return false;
  return Join(scene, from, to, stands_on).clear();
}

}  // namespace traj
