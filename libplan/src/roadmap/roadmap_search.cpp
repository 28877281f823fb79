#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "bend_tree.h"
#include "bends.h"
#include "frontier.h"
#include "plan/roadmap/roadmap.h"

namespace plan {
namespace {

constexpr double kLoose = 0.08;  // how far a turn may miss wrapping: bends stand in for their part
constexpr std::size_t kLinks = 8;    // blocked ones that cost as much as a bend settled
constexpr double kBucket = 0x1p-10;  // of the straight line: how much longer paths of a bucket are

// Whether a path that comes from one direction and leaves in another, both tangent, wraps around
// the box: seen from outside it turns by at least a half circle.
bool wraps(const Across& in, const Across& out) {
  if (in.second_side() == out.second_side()) return false;
  return in.second_side() ? out.ratio() <= in.ratio() + kLoose : out.ratio() >= in.ratio() - kLoose;
}

}  // namespace

struct RoadmapSearch::Impl {
  Impl(const geom::CollisionScene& scene, const Roadmap& roadmap)
      : scene_(&scene), roadmap_(&roadmap), tree_(roadmap.bends), visits_(roadmap.bends.size()) {}

  RoadmapResult search(const Vec3& from, const Vec3& to, const RoadmapLimits& limits);

  struct Visit {
    double cost = 0;         // of the best way so far; kSettled once the bend was expanded
    std::uint32_t from = 0;  // bend, or kStart
    std::uint32_t stamp = 0;
  };
  static constexpr std::uint32_t kStart = 0xffffffffu;
  static constexpr double kSettled = -1;

  void begin(const Vec3& from, const Vec3& to, const RoadmapLimits& limits);
  void open_node(std::uint32_t node);
  void push_node(std::uint32_t node);
  bool settle(const Open& top);
  bool known_as_near(std::uint32_t bend, double cost) const;
  void reach(std::uint32_t from, std::uint32_t to, double cost);
  void look_around(std::uint32_t bend, double cost, const Across& in);
  std::span<const std::uint32_t> onward(std::uint32_t bend, const Across& in) const;
  void expand(std::uint32_t bend, double cost, const Across& in);
  Across arrival(std::uint32_t bend) const;
  bool sees_goal(std::uint32_t bend, const Across& in) const;
  geom::Polyline trace(std::uint32_t bend) const;

  const geom::CollisionScene* scene_;
  const Roadmap* roadmap_;
  BendTree tree_;
  std::vector<Visit> visits_;
  std::uint32_t stamp_ = 0;
  Frontier open_;
  Vec3 from_;
  Vec3 to_;
  double weight_ = 1;
  std::size_t blocked_ = 0;  // links from the start
};

void RoadmapSearch::Impl::begin(const Vec3& from, const Vec3& to, const RoadmapLimits& limits) {
  from_ = from;
  to_ = to;
  weight_ = limits.weight;
  blocked_ = 0;
  if (++stamp_ == 0) {
    std::fill(visits_.begin(), visits_.end(), Visit{});
    stamp_ = 1;
  }
  const double straight = (to - from).norm();
  open_.start(weight_ * straight, std::max(kBucket * weight_ * straight, 1e-6));
  if (!tree_.empty()) push_node(tree_.root());
}

void RoadmapSearch::Impl::push_node(std::uint32_t node) {
  const double bound = tree_.distance(node, from_) + weight_ * tree_.distance(node, to_);
  open_.push({bound, 0, node, Open::node});
}

void RoadmapSearch::Impl::open_node(std::uint32_t index) {
  const BendTree::Node& node = tree_.node(index);
  for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
    if (!node.leaf) {
      push_node(i);
      continue;
    }
    const Bend& bend = roadmap_->bends[i];
    if (!across(bend, from_ - bend.position).tangent()) continue;
    const double cost = (bend.position - from_).norm();
    open_.push({cost + weight_ * (to_ - bend.position).norm(), cost, i, Open::unlinked});
  }
}

inline bool RoadmapSearch::Impl::known_as_near(std::uint32_t bend, double cost) const {
  const Visit& visit = visits_[bend];
  return visit.stamp == stamp_ && visit.cost <= cost;
}

inline void RoadmapSearch::Impl::reach(std::uint32_t i, std::uint32_t j, double through) {
  visits_[j] = {through, i, stamp_};
  open_.push(
      {through + weight_ * (to_ - roadmap_->bends[j].position).norm(), through, j, Open::reached});
}

// Where the roadmap has no edges: those that matter, looked for.
void RoadmapSearch::Impl::look_around(std::uint32_t i, double cost, const Across& in) {
  const Roadmap& map = *roadmap_;
  const Bend& bend = map.bends[i];
  const double reach2 = map.spec.reach * map.spec.reach;
  tree_.for_near(bend.position, map.spec.reach, [&](std::uint32_t j) {
    const Bend& other = map.bends[j];
    const Vec3 d = other.position - bend.position;
    const double square = d.squaredNorm();
    if (j == i || square > reach2) return;
    const double through = cost + std::sqrt(square);
    if (known_as_near(j, through)) return;
    const Across out = across(bend, d);
    if (!out.tangent() || !wraps(in, out) || !across(other, -d).tangent()) return;
    if (!scene_->hits(bend.position, other.position)) reach(i, j, through);
  });
}

// The edges that keep wrapping around the bend's box for a path that comes from `in`.
std::span<const std::uint32_t> RoadmapSearch::Impl::onward(std::uint32_t i,
                                                           const Across& in) const {
  const Roadmap& map = *roadmap_;
  const Bend& bend = map.bends[i];
  const auto edges = map.to.subspan(map.first[i], map.first[i + 1] - map.first[i]);
  const auto ratio = [&](std::uint32_t j) {
    require_bend(map, j);
    return across(bend, map.bends[j].position - bend.position).ratio();
  };
  if (in.second_side()) {  // out on the first side, by at most as much
    const auto first = edges.first(map.split[i]);
    const double most = in.ratio() + kLoose;
    const auto end = std::partition_point(first.begin(), first.end(),
                                          [&](std::uint32_t j) { return ratio(j) <= most; });
    return {first.begin(), end};
  }
  const auto second = edges.subspan(map.split[i]);  // by at least as much
  const double least = in.ratio() - kLoose;
  const auto begin = std::partition_point(second.begin(), second.end(),
                                          [&](std::uint32_t j) { return ratio(j) < least; });
  return {begin, second.end()};
}

void RoadmapSearch::Impl::expand(std::uint32_t i, double cost, const Across& in) {
  const Roadmap& map = *roadmap_;
  const Vec3& here = map.bends[i].position;
  for (const std::uint32_t j : onward(i, in)) {
    if (j >= map.bends.size()) require_bend(map, j);  // which is no call for most
    const double through = cost + (map.bends[j].position - here).norm();
    if (!known_as_near(j, through)) reach(i, j, through);
  }
}

geom::Polyline RoadmapSearch::Impl::trace(std::uint32_t bend) const {
  geom::Polyline path = {to_};
  for (; bend != kStart; bend = visits_[bend].from) {
    path.push_back(roadmap_->bends[bend].position);
  }
  path.push_back(from_);
  std::reverse(path.begin(), path.end());
  return path;
}

// Whether this is the shortest way to a bend that was not settled yet.
bool RoadmapSearch::Impl::settle(const Open& top) {
  const std::uint32_t i = top.index;
  if (top.kind == Open::unlinked) {
    if (known_as_near(i, top.cost)) return false;
    if (scene_->hits(from_, roadmap_->bends[i].position)) {
      ++blocked_;
      return false;
    }
    visits_[i] = {top.cost, kStart, stamp_};
  } else if (visits_[i].cost < top.cost) {
    return false;
  }
  visits_[i].cost = kSettled;
  return true;
}

Across RoadmapSearch::Impl::arrival(std::uint32_t i) const {
  const std::uint32_t before = visits_[i].from;
  const Vec3& back = before == kStart ? from_ : roadmap_->bends[before].position;
  return across(roadmap_->bends[i], back - roadmap_->bends[i].position);
}

// Whether a path that comes from `in` may end with the straight line to the goal.
bool RoadmapSearch::Impl::sees_goal(std::uint32_t i, const Across& in) const {
  const Bend& bend = roadmap_->bends[i];
  const Across out = across(bend, to_ - bend.position);
  return out.tangent() && wraps(in, out) && !scene_->hits(bend.position, to_);
}

RoadmapResult RoadmapSearch::Impl::search(const Vec3& from, const Vec3& to,
                                          const RoadmapLimits& limits) {
  RoadmapResult result;
  begin(from, to, limits);
  const bool has_edges = !roadmap_->first.empty();
  double longest = std::numeric_limits<double>::infinity();
  while (!open_.empty() && open_.first().bound <= longest) {
    const Open top = open_.pop();
    if (top.kind == Open::node) {
      open_node(top.index);
      continue;
    }
    if (settle(top)) {
      if (++result.settled > limits.settled) break;
    } else {
      if (has_edges && blocked_ / kLinks > limits.settled) break;
      continue;
    }
    const Across in = arrival(top.index);
    if (sees_goal(top.index, in)) {
      if (result.paths.empty()) longest = top.bound * (1 + limits.beyond);
      result.paths.push_back(trace(top.index));
      if (result.paths.size() == limits.paths) return result;
    }
    if (has_edges) {
      expand(top.index, top.cost, in);
    } else {
      look_around(top.index, top.cost, in);
    }
  }
  result.gave_up = result.paths.empty();
  return result;
}

RoadmapSearch::RoadmapSearch(const geom::CollisionScene& scene, const Roadmap& roadmap)
    : impl_(std::make_unique<Impl>(scene, roadmap)) {}
RoadmapSearch::~RoadmapSearch() = default;

RoadmapResult RoadmapSearch::search(const Vec3& from, const Vec3& to, const RoadmapLimits& limits) {
  return impl_->search(from, to, limits);
}

}  // namespace plan
