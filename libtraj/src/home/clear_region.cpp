#include "home/clear_region.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geom/base/precondition.h"
#include "geom/shape/hull.h"

namespace traj {
namespace {

using geom::Aabb;

constexpr double kSure = 1e-9;       // m, for the rounding of what is added to places
constexpr double kShortest = 20;     // m: shorter parts are not cut
constexpr double kPartOverSize = 2;  // parts are cut until they are so long, in sizes of the region
constexpr double kRounding = 1e-14;  // of a sum of three products, of its size

Aabb box_of(const Prism& prism) {
  Aabb box{{prism.plan.front().x(), prism.plan.front().y(), prism.low},
           {prism.plan.front().x(), prism.plan.front().y(), prism.high}};
  for (const Vec2& p : prism.plan) {
    box = geom::merged(box, {{p.x(), p.y(), prism.low}, {p.x(), p.y(), prism.high}});
  }
  return box;
}

Vec3 mean(const Prism& prism) {
  Vec2 sum = Vec2::Zero();
  for (const Vec2& p : prism.plan) sum += p;
  sum /= static_cast<double>(prism.plan.size());
  return {sum.x(), sum.y(), 0.5 * (prism.low + prism.high)};
}

bool in_bounds(const geom::CollisionScene& scene, const Aabb& box,
               const std::optional<double>& stands_on) {
  if (!scene.free_bounds()) return false;
  Aabb free = *scene.free_bounds();
  if (stands_on) free.min.z() = -geom::kFarthest;
  return geom::contains(free, box.min) && geom::contains(free, box.max);
}

// Whether one of the grown boxes that meet `near` is of those that `is_met` names.
template <class IsMet>
bool any_met(const geom::CollisionScene& scene, const Aabb& near,
             const std::optional<double>& stands_on, const IsMet& is_met) {
  const Vec3 sure = Vec3::Constant(kSure);
  for (const std::size_t i : scene.boxes_meeting({near.min - sure, near.max + sure})) {
    if (stands_on && scene.map().box(i).max.z() <= *stands_on) continue;
    const Aabb grown = scene.grown(i);
    if (is_met(Aabb{grown.min - sure, grown.max + sure})) return true;
  }
  return false;
}

// The hull of a prism and a point, cut across the way from the prism's middle to the point.
class Join {
 public:
  Join(const geom::CollisionScene& scene, const Prism& from, const Vec3& to,
       const std::optional<double>& stands_on)
      : scene_(scene),
        from_(box_of(from)),
        mean_(mean(from)),
        to_(to),
        stands_on_(stands_on),
        hull_(corners(from)),
        around_(from) {
    hull_.push_back(to);
    around_.plan.push_back(to.head<2>());
    around_.plan = plan_hull(std::move(around_.plan));
    middle_ = 0.5 * (from_.min + from_.max);
    length_ = (to - middle_).norm();
    size_ = (from_.max - from_.min).norm();
    const Vec3 way = to - middle_;
    const double across = way.head<2>().norm();
    if (across > 0) slope_ = Vec3(-way.x() * way.z(), -way.y() * way.z(), across * across);
  }

  bool clear() const { return (stands_on_ || !scene_.hits(mean_, to_)) && clear(0, 1); }

 private:
  // The part with shares of the way from `a` to `b`: at a share s it is the prism, made smaller
  // by 1 - s about the point.
  bool clear(double a, double b) const {
    if (!stands_on_ && !scene_.sweep_hits(at(a), at(b), scene_.half() + half_at(a))) return true;
    if ((b - a) * length_ > std::max(kShortest, kPartOverSize * (1 - a) * size_)) {
      const double middle = 0.5 * (a + b);
      return clear(a, middle) && clear(middle, b);
    }
    const Aabb near = geom::merged(box_at(a), box_at(b));
    Prism part = around_;
    part.low = near.min.z();
    part.high = near.max.z();
    return !any_met(scene_, near, stands_on_, [&](const Aabb& grown) {
      return meets(part, grown) && !apart_by_slope(grown) && geom::hull_meets(hull_, grown);
    });
  }

  // Whether a plane with the slope of the way lies between the hull and a box: this is cheaper to
  // find out than hull_meets(), and true of most boxes that are below.
  bool apart_by_slope(const Aabb& box) const {
    double least = std::numeric_limits<double>::infinity();
    double size = 0;
    for (const Vec3& p : hull_) {
      least = std::min(least, slope_.dot(p));
      size = std::max(size, slope_.cwiseAbs().dot(p.cwiseAbs()));
    }
    double most = 0;
    for (int i = 0; i < 3; ++i) {
      most += std::max(slope_[i] * box.min[i], slope_[i] * box.max[i]);
      size += std::abs(slope_[i]) * std::max(std::abs(box.min[i]), std::abs(box.max[i]));
    }
    return least - most > kRounding * size;
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
  Vec3 mean_;  // of the prism
  Vec3 to_;
  const std::optional<double>& stands_on_;
  std::vector<Vec3> hull_;
  Prism around_;  // in plan around the hull
  Vec3 middle_ = Vec3::Zero();
  Vec3 slope_ = Vec3::UnitZ();
  double length_ = 0;
  double size_ = 0;
};

}  // namespace

bool clear_region(const geom::CollisionScene& scene, const Prism& region,
                  const std::optional<double>& stands_on) {
  const Aabb box = box_of(region);
  return in_bounds(scene, box, stands_on) &&
         !any_met(scene, box, stands_on, [&](const Aabb& grown) { return meets(region, grown); });
}

bool clear_join(const geom::CollisionScene& scene, const Prism& from, const Vec3& to,
                const std::optional<double>& stands_on) {
  if (!in_bounds(scene, box_of(from), stands_on) || !in_bounds(scene, {to, to}, stands_on)) {
    return false;
  }
  return Join(scene, from, to, stands_on).clear();
}

}  // namespace traj
