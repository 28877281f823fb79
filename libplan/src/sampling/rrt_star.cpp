#include "rrt_star.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "roadmap/point_index.h"
#include "sampling_search.h"
#include "spheroid.h"

namespace plan {
namespace {

constexpr double kShorter = 1e-3;  // of the length: less is no progress
constexpr int kDraws = 100;        // tries at a sample in both the bounds and the spheroid
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

double volume(const geom::Aabb& box) { return (box.max - box.min).prod(); }

// The natural logarithm of x >= 1 and the cube root, of exact operations and divisions alone: those
// of the C library differ from machine to machine in their last digit.
double natural_log(double x) {
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);  // in [0.5, 1)
  const double t = (mantissa - 1) / (mantissa + 1);  // log = 2 atanh(t), |t| <= 1/3
  double series = 0;
  for (int k = 35; k > 0; k -= 2) series = series * t * t + 1.0 / k;
  return exponent * std::numbers::ln2 + 2 * t * series;
}

double cube_root(double v) {
  if (!(v > 0)) return 0;
  double root = std::max(v, 1.0);
  for (;;) {  // Newton's, from above: it falls until rounding stops it
    const double next = (2 * root + v / (root * root)) / 3;
    if (!(next < root)) return root;
    root = next;
  }
}

class RrtStar : SamplingSearch {
 public:
  RrtStar(const geom::CollisionScene& scene, const Vec3& from, const Vec3& to,
          const SamplingOptions& options, bool informed)
      : SamplingSearch(scene, from, to, options),
        informed_(informed),
        whole_volume_(volume(*scene.free_bounds())),
        promising_volume_(whole_volume_) {}

  SamplingResult run() {
    insert_root();
    while (!optimal() && !idle() && next_iteration()) {
      const Vec3 sample = next_sample();
      const std::uint32_t near = index_.nearest(sample);
      const auto p = step_towards(near, sample);
      if (!p) continue;
      const std::uint32_t node = insert(*p, near);
      if (goal_ == kNone) {
        if (*p == to_) {
          goal_ = node;
        } else if (sees_goal_within_step(node)) {
          goal_ = insert(to_, node);
        }
      }
      if (goal_ != kNone) note_length();
    }
    if (goal_ != kNone) {
      result_.path = path_to_root(goal_);
      std::reverse(result_.path.begin(), result_.path.end());
    }
    return std::move(result_);
  }

 private:
  struct Neighbour {
    double through;  // metres from the start by way of it
    double distance;
    std::uint32_t node;
  };

  double length() const { return result_.tree.cost[goal_]; }

  bool optimal() const { return goal_ != kNone && length() <= (to_ - from_).norm(); }

  bool idle() const {
    return options_.patience > 0 && goal_ != kNone &&
           result_.iterations - shortened_at_ >= options_.patience;
  }

  void note_length() {
    if (!result_.found) found_first(length());
    if (length() < (1 - kShorter) * shortened_to_) {
      shortened_to_ = length();
      shortened_at_ = result_.iterations;
    }
    if (!informed_ || (spheroid_ && length() >= informed_by_)) return;
    informed_by_ = length();
    spheroid_.emplace(from_, to_, length());
    promising_volume_ = std::min(whole_volume_, spheroid_->volume());
    promising_ = static_cast<std::size_t>(
        std::count_if(result_.tree.points.begin(), result_.tree.points.end(),
                      [&](const Vec3& p) { return spheroid_->contains(p); }));
  }

  Vec3 next_sample() {
    if (!spheroid_) return goal_ == kNone ? sample_bounds_or_goal() : sample_bounds();
    // Evenly over what the spheroid and the bounds share, from the smaller of the two.
    const bool from_bounds = promising_volume_ == whole_volume_;
    const int draws = whole_volume_ > 0 ? kDraws : 0;
    for (int i = 0; i < draws; ++i) {
      const Vec3 p = from_bounds ? sample_bounds() : spheroid_->image(sample_ball());
      if (from_bounds ? spheroid_->contains(p) : scene_.inside_bounds(p)) return p;
    }
    // They share next to nothing, as where the bounds are flat. The nearest point of the bounds is
    // no farther from either end than the sample.
    const geom::Aabb& bounds = *scene_.free_bounds();
    return spheroid_->image(sample_ball()).cwiseMax(bounds.min).cwiseMin(bounds.max);
  }

  double neighbourhood() const {
    if (!(promising_volume_ > 0)) return *options_.radius;
    const double n = static_cast<double>(std::max<std::size_t>(promising_, 1));
    return std::min(*options_.radius,
                    2 * cube_root(promising_volume_ * natural_log(n) / (std::numbers::pi * n)));
  }

  void insert_root() {
    index_.insert(from_, add_root(from_, 0));
    children_.emplace_back();
    promising_ = 1;
  }

  // A new node at `p`, which the node `near` sees: below the neighbour it is nearest to the start
  // by, then above those that are nearer by way of it.
  std::uint32_t insert(const Vec3& p, std::uint32_t near) {
    const std::vector<Neighbour> around = neighbours(p, near);
    std::uint32_t parent = near;
    for (const Neighbour& n : around) {
      if (n.node == near || scene_.free(point(n.node), p)) {
        parent = n.node;
        break;
      }
    }
    const std::uint32_t node = add_child(p, parent);
    index_.insert(p, node);
    children_.emplace_back();
    children_[parent].push_back(node);
    promising_ += !spheroid_ || spheroid_->contains(p);
    for (const Neighbour& n : around) {
      if (result_.tree.cost[node] + n.distance < result_.tree.cost[n.node] &&
          scene_.free(p, point(n.node))) {
        rewire(n.node, node);
      }
    }
    return node;
  }

  // `near` and the nodes in the neighbourhood, the best to come by first.
  std::vector<Neighbour> neighbours(const Vec3& p, std::uint32_t near) const {
    std::vector<Neighbour> out;
    const auto add = [&](std::uint32_t node) {
      const double distance = (p - point(node)).norm();
      out.push_back({result_.tree.cost[node] + distance, distance, node});
    };
    add(near);
    for (const std::uint32_t node : index_.within(p, neighbourhood())) {
      if (node != near) add(node);
    }
    std::sort(out.begin(), out.end(), [](const Neighbour& a, const Neighbour& b) {
      return a.through != b.through ? a.through < b.through : a.node < b.node;
    });
    return out;
  }

  // Costs are sums that only grow away from the start, rounded as they are, so a node that is
  // nearer by way of `parent` is none of its ancestors.
  void rewire(std::uint32_t node, std::uint32_t parent) {
    SearchTree& tree = result_.tree;
    std::erase(children_[tree.parent[node]], node);
    children_[parent].push_back(node);
    tree.parent[node] = parent;
    std::vector<std::uint32_t> changed = {node};
    while (!changed.empty()) {
      const std::uint32_t i = changed.back();
      changed.pop_back();
      tree.cost[i] = tree.cost[tree.parent[i]] + (point(i) - point(tree.parent[i])).norm();
      changed.insert(changed.end(), children_[i].begin(), children_[i].end());
    }
  }

  bool informed_;
  PointIndex index_;
  std::vector<std::vector<std::uint32_t>> children_;
  std::uint32_t goal_ = kNone;
  double shortened_to_ = std::numeric_limits<double>::infinity();  // and when: for `patience`
  std::size_t shortened_at_ = 0;
  std::optional<Spheroid> spheroid_;  // once a path is known, of informed_by_ metres
  double informed_by_ = 0;
  double whole_volume_;      // of the bounds
  double promising_volume_;  // where samples come from, and the nodes there
  std::size_t promising_ = 0;
};

}  // namespace

SamplingResult grow_rrt_star(const geom::CollisionScene& scene, const Vec3& from, const Vec3& to,
                             const SamplingOptions& options, bool informed) {
  return RrtStar(scene, from, to, options, informed).run();
}

}  // namespace plan
