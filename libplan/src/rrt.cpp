#include "plan/rrt.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "geom/error.h"
#include "geom/random.h"
#include "point_index.h"
#include "spheroid.h"

namespace plan {
namespace {

using geom::Polyline;

constexpr std::size_t kAskStop = 16;  // iterations
constexpr double kShorter = 1e-3;     // of the length: less is no progress
constexpr int kDraws = 100;           // tries at a sample in both the bounds and the spheroid
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

void check(const SamplingOptions& options) {
  const auto need = [](bool holds, std::string_view what, double found) {
    if (!holds) {
      throw geom::InputError("sampling", fmt::format("expected {}, found {}", what, found));
    }
  };
  need(options.step > 0, "a step > 0 metres", options.step);
  need(options.goal_bias >= 0 && options.goal_bias <= 1, "a goal bias in [0, 1]",
       options.goal_bias);
  need(options.radius >= 0, "a radius >= 0 metres", options.radius);
  need(options.iterations >> 31 == 0, "fewer than 2^31 iterations",  // nodes have 32-bit indices
       static_cast<double>(options.iterations));
}

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

// What every method works with: one search, from its first sample to its result.
class Search {
 public:
  Search(const geom::CollisionScene& scene, const Vec3& from, const Vec3& to,
         const SamplingOptions& options)
      : scene_(scene), from_(from), to_(to), options_(options), random_(options.seed) {}

 protected:
  // By value: nodes move while the tree grows.
  Vec3 point(std::uint32_t node) const { return result_.tree.points[node]; }
  std::size_t size() const { return result_.tree.points.size(); }

  // Whether there is another iteration to do, which is counted.
  bool next_iteration() {
    if (result_.iterations == options_.iterations) return false;
    if (options_.stop && result_.iterations % kAskStop == 0 && options_.stop()) {
      result_.stopped = true;
      return false;
    }
    ++result_.iterations;
    return true;
  }

  Vec3 sample_bounds() {
    const geom::Aabb& bounds = *scene_.free_bounds();
    Vec3 p;
    for (int k = 0; k < 3; ++k) {
      p[k] = std::min(random_.uniform(bounds.min[k], bounds.max[k]), bounds.max[k]);
    }
    return p;
  }

  Vec3 sample_ball() {
    for (;;) {
      Vec3 p;
      for (int k = 0; k < 3; ++k) p[k] = random_.uniform(-1, 1);
      if (p.squaredNorm() <= 1) return p;
    }
  }

  Vec3 sample_bounds_or_goal() {
    return random_.chance(options_.goal_bias) ? to_ : sample_bounds();
  }

  std::uint32_t add_root(const Vec3& p, std::uint8_t tree) {
    return add(p, static_cast<std::uint32_t>(size()), tree, 0);
  }

  std::uint32_t add_child(const Vec3& p, std::uint32_t parent) {
    return add(p, parent, result_.tree.tree[parent],
               result_.tree.cost[parent] + (p - point(parent)).norm());
  }

  // EXTEND without the new node: where one step from `near` towards `target` ends, if that is
  // progress and free. What is within a step of the target ends there exactly.
  std::optional<Vec3> step_towards(std::uint32_t near, const Vec3& target) const {
    const Vec3 at = point(near);
    const double distance = (target - at).norm();
    const Vec3 p =
        distance <= options_.step ? target : Vec3(at + (target - at) * (options_.step / distance));
    if (p == at || !scene_.free(at, p)) return std::nullopt;
    return p;
  }

  bool sees_goal_within_step(std::uint32_t node) const {
    return (to_ - point(node)).norm() <= options_.step && scene_.free(point(node), to_);
  }

  Polyline path_to_root(std::uint32_t node) const {
    Polyline path = {point(node)};
    for (; result_.tree.parent[node] != node; path.push_back(point(node))) {
      node = result_.tree.parent[node];
    }
    return path;
  }

  void found_first(double length) {
    result_.found = true;
    result_.first_found = result_.iterations;
    result_.first_length = length;
  }

  const geom::CollisionScene& scene_;
  const Vec3 from_;
  const Vec3 to_;
  const SamplingOptions& options_;
  geom::SplitMix64 random_;
  SamplingResult result_;

 private:
  std::uint32_t add(const Vec3& p, std::uint32_t parent, std::uint8_t tree, double cost) {
    result_.tree.points.push_back(p);
    result_.tree.parent.push_back(parent);
    result_.tree.first_parent.push_back(parent);
    result_.tree.tree.push_back(tree);
    result_.tree.cost.push_back(cost);
    return static_cast<std::uint32_t>(size() - 1);
  }
};

class Rrt : Search {
 public:
  using Search::Search;

  SamplingResult run() {
    index_.insert(from_, add_root(from_, 0));
    while (next_iteration()) {
      const Vec3 sample = sample_bounds_or_goal();
      const std::uint32_t near = index_.nearest(sample);
      const auto p = step_towards(near, sample);
      if (!p) continue;
      std::uint32_t node = add_child(*p, near);
      index_.insert(*p, node);
      if (*p != to_) {
        if (!sees_goal_within_step(node)) continue;
        node = add_child(to_, node);
      }
      found_first(result_.tree.cost[node]);
      result_.path = path_to_root(node);
      std::reverse(result_.path.begin(), result_.path.end());
      break;
    }
    return std::move(result_);
  }

 private:
  PointIndex index_;
};

class RrtConnect : Search {
 public:
  using Search::Search;

  SamplingResult run() {
    index_[0].insert(from_, add_root(from_, 0));
    index_[1].insert(to_, add_root(to_, 1));
    for (std::size_t side = 0; next_iteration(); side = 1 - side) {
      const Vec3 sample = sample_bounds();
      const auto node = extend(side, index_[side].nearest(sample), sample);
      if (!node) continue;
      const auto met = connect(1 - side, point(*node));
      if (!met) continue;
      join(side == 0 ? *node : *met, side == 0 ? *met : *node);
      break;
    }
    return std::move(result_);
  }

 private:
  std::optional<std::uint32_t> extend(std::size_t side, std::uint32_t near, const Vec3& target) {
    const auto p = step_towards(near, target);
    if (!p) return std::nullopt;
    const std::uint32_t node = add_child(*p, near);
    index_[side].insert(*p, node);
    return node;
  }

  // The node of that tree that stands on `target`, if it could be grown there. The newest node is
  // always the nearest.
  std::optional<std::uint32_t> connect(std::size_t side, const Vec3& target) {
    std::uint32_t node = index_[side].nearest(target);
    while (point(node) != target) {
      if (!next_iteration()) return std::nullopt;
      const auto grown = extend(side, node, target);
      if (!grown) return std::nullopt;
      node = *grown;
    }
    return node;
  }

  void join(std::uint32_t of_start, std::uint32_t of_goal) {
    found_first(result_.tree.cost[of_start] + result_.tree.cost[of_goal]);
    result_.path = path_to_root(of_start);
    std::reverse(result_.path.begin(), result_.path.end());
    const Polyline rest = path_to_root(of_goal);
    result_.path.insert(result_.path.end(), rest.begin() + 1, rest.end());
  }

  PointIndex index_[2];
};

// Both star methods.
class RrtStar : Search {
 public:
  RrtStar(const geom::CollisionScene& scene, const Vec3& from, const Vec3& to,
          const SamplingOptions& options, bool informed)
      : Search(scene, from, to, options),
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
    if (!(promising_volume_ > 0)) return options_.radius;
    const double n = static_cast<double>(std::max<std::size_t>(promising_, 1));
    return std::min(options_.radius,
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

SamplingResult straight_line(const Vec3& from, const Vec3& to) {
  SamplingResult result;
  result.found = true;
  result.path = {from, to};
  result.first_length = (to - from).norm();
  result.tree = {{from, to}, {0, 0}, {0, 0}, {0, result.first_length}, {0, 0}};
  return result;
}

}  // namespace

std::string_view name(SamplingMethod method) {
  switch (method) {
    case SamplingMethod::rrt:
      return "rrt";
    case SamplingMethod::rrt_connect:
      return "rrt-connect";
    case SamplingMethod::rrt_star:
      return "rrt-star";
    case SamplingMethod::informed_rrt_star:
      return "informed-rrt-star";
  }
  return "";
}

SamplingResult sample_path(const geom::CollisionScene& scene, const Vec3& from, const Vec3& to,
                           SamplingMethod method, const SamplingOptions& options) {
  check(options);
  if (!scene.free(from) || !scene.free(to)) return {};
  if (from == to || (options.straight_first && scene.free(from, to)))
    return straight_line(from, to);
  switch (method) {
    case SamplingMethod::rrt:
      return Rrt(scene, from, to, options).run();
    case SamplingMethod::rrt_connect:
      return RrtConnect(scene, from, to, options).run();
    case SamplingMethod::rrt_star:
      return RrtStar(scene, from, to, options, false).run();
    case SamplingMethod::informed_rrt_star:
      return RrtStar(scene, from, to, options, true).run();
  }
  return {};
}

}  // namespace plan
