#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "bend_tree.h"
#include "bends.h"
#include "frontier.h"
#include "loaded_tiles.h"
#include "plan/roadmap/roadmap.h"
#include "plan/roadmap/roadmap_fill.h"
#include "planner/last_blockers.h"
#include "shadows.h"

namespace plan {
namespace {

constexpr double kLoose = 0.08;  // how far a turn may miss wrapping: bends stand in for their part
constexpr std::size_t kLinks = 8;   // blocked ones that cost as much as a bend settled
constexpr std::size_t kBlind = 32;  // blocked ones, after which it pays to know what hides
constexpr std::size_t kKept = std::size_t{1} << 21;  // bends that stay loaded for the next search
constexpr std::size_t kKeptTiles = std::size_t{1} << 14;
constexpr double kBucket = 0x1p-12;  // of the straight line: how much longer paths of a bucket are

// Whether a path that comes from one direction and leaves in another, both tangent, wraps around
// the box: seen from outside it turns by at least a half circle.
bool wraps(const Across& in, const Across& out) {
  if (in.second_side() == out.second_side()) return false;
  return in.second_side() ? out.ratio() <= in.ratio() + kLoose : out.ratio() >= in.ratio() - kLoose;
}

// Where a path may leave a bend that it came to from a direction, as tangent() and wraps() have it:
// a quadrant across the box edge, less what is on the near side of a line. They forgive a
// millimetre, so this forgives more.
class Onward {
 public:
  Onward(const Bend& bend, const Across& in)
      : bend_(bend),
        first_axis_((bend.axis + 1) % 3),
        second_axis_((bend.axis + 2) % 3),
        second_(!in.second_side()) {
    ratio_ = second_ ? std::max(0.0, in.ratio() - kLoose) : std::min(1.0, in.ratio() + kLoose);
  }

  // Whether a path may leave in a direction.
  bool goes(const Vec3& direction) const {
    const Across out{direction[first_axis_] * bend_.outward[0],
                     direction[second_axis_] * bend_.outward[1]};
    if (out.second_side() != second_ || !out.tangent()) return false;
    return second_ ? out.ratio() >= ratio_ : out.ratio() <= ratio_;
  }

  // Whether none of the node's bends can be where.
  bool misses(const BendTree::Node& node) const {
    constexpr double kForgiven = 4e-3;  // metres
    const auto [x0, x1] = range(node, 0);
    const auto [y0, y1] = range(node, 1);
    if (second_ ? x1 < -kForgiven || y0 > kForgiven : x0 > kForgiven || y1 < -kForgiven)
      return true;
    return ratio_ * x0 + (1 - ratio_) * y0 > kForgiven;
  }

 private:
  // Along the first or second axis across, outward from the bend.
  std::pair<double, double> range(const BendTree::Node& node, int which) const {
    const int k = which == 0 ? first_axis_ : second_axis_;
    const double low = node.min[k] - bend_.position[k];
    const double high = node.max[k] - bend_.position[k];
    return bend_.outward[which] > 0 ? std::pair(low, high) : std::pair(-high, -low);
  }

  const Bend& bend_;
  int first_axis_;  // across the box edge
  int second_axis_;
  bool second_;   // side to leave on
  double ratio_;  // of Across, at most on the first side, at least on the second
};

// Of bends that tie: the one whose place is lowest, however they are numbered.
struct LowestPlace {
  const LoadedTiles* tiles;

  bool operator()(const Open& a, const Open& b) const {
    if (a.kind == Open::node) return a.index < b.index;
    const Bend& one = tiles->bends()[a.index];
    const Bend& other = tiles->bends()[b.index];
    const auto key = [](const Bend& bend) {
      const Vec3& p = bend.position;
      return std::tuple(p.x(), p.y(), p.z(), bend.axis, bend.outward);
    };
    return key(one) < key(other);
  }
};

}  // namespace

struct RoadmapSearch::Impl {
  Impl(const geom::CollisionScene& scene, TileSource& source)
      : scene_(&scene), source_(&source), tiles_(source) {}
  Impl(const geom::CollisionScene& scene, std::unique_ptr<TileSource> source)
      : Impl(scene, *source) {
    own_ = std::move(source);
  }
  Impl(const geom::CollisionScene& scene, std::vector<Bend> bends, double reach)
      : scene_(&scene),
        tree_(std::in_place, bends),
        tiles_(std::move(bends), *tree_),
        reach_(reach) {}

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
  void make_room();
  bool settle(const Open& top);
  bool known_as_near(std::uint32_t bend, double cost) const;
  void reach(std::uint32_t from, std::uint32_t to, double cost);
  void look_around(std::uint32_t bend, double cost, const Across& in);
  std::span<const std::uint32_t> onward(std::uint32_t bend, const Across& in,
                                        const LoadedTiles::Edges& edges);
  void expand(std::uint32_t bend, double cost, const Across& in);
  Across arrival(std::uint32_t bend) const;
  bool linked_to_start(std::uint32_t bend);
  bool sees_goal(std::uint32_t bend, const Across& in);
  geom::Polyline trace(std::uint32_t bend) const;

  const geom::CollisionScene* scene_;
  std::unique_ptr<TileSource> own_;
  TileSource* source_ = nullptr;  // none where there are no edges
  std::optional<BendTree> tree_;  // where there are no edges
  LoadedTiles tiles_;
  double reach_ = 0;
  std::vector<Visit> visits_;
  std::uint32_t stamp_ = 0;
  Frontier<LowestPlace> open_{LowestPlace{&tiles_}};
  Vec3 from_;
  Vec3 to_;
  double weight_ = 1;
  LastBlockers from_start_{*scene_};
  LastBlockers to_goal_{*scene_};
  LastBlockers between_{*scene_};  // bends
  std::size_t blocked_ = 0;        // links from the start
  std::size_t unseen_ = 0;         // by the goal
  std::optional<Shadows> hidden_from_start_;
  std::optional<Shadows> hidden_from_goal_;
};

void RoadmapSearch::Impl::begin(const Vec3& from, const Vec3& to, const RoadmapLimits& limits) {
  from_ = from;
  to_ = to;
  weight_ = limits.weight;
  blocked_ = 0;
  unseen_ = 0;
  hidden_from_start_.reset();
  hidden_from_goal_.reset();
  if (source_ && (tiles_.bends().size() > kKept || tiles_.tiles() > kKeptTiles)) {
    tiles_ = LoadedTiles(*source_);
    visits_.clear();
  }
  if (++stamp_ == 0) {
    std::fill(visits_.begin(), visits_.end(), Visit{});
    stamp_ = 1;
  }
  const double straight = (to - from).norm();
  open_.start(weight_ * straight, std::max(kBucket * weight_ * straight, 1e-6));
  if (!tiles_.empty()) push_node(tiles_.root());
}

// Nodes cost more than anything, so that they come before bends that tie with them.
void RoadmapSearch::Impl::push_node(std::uint32_t index) {
  const BendTree::Node& node = tiles_.node(index);
  const double bound = BendTree::distance(node, from_) + weight_ * BendTree::distance(node, to_);
  open_.push({bound, std::numeric_limits<double>::infinity(), index, Open::node});
}

void RoadmapSearch::Impl::open_node(std::uint32_t index) {
  if (hidden_from_start_ && hidden_from_start_->hides(BendTree::box(tiles_.node(index)))) return;
  const BendTree::Node node = tiles_.opened(index);
  make_room();
  for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
    if (!node.leaf) {
      push_node(i);
      continue;
    }
    const Bend& bend = tiles_.bends()[i];
    if (!across(bend, from_ - bend.position).tangent()) continue;
    const double cost = (bend.position - from_).norm();
    open_.push({cost + weight_ * (to_ - bend.position).norm(), cost, i, Open::unlinked});
  }
}

// For bends that were loaded meanwhile.
void RoadmapSearch::Impl::make_room() {
  if (visits_.size() < tiles_.bends().size()) visits_.resize(tiles_.bends().size());
}

inline bool RoadmapSearch::Impl::known_as_near(std::uint32_t bend, double cost) const {
  const Visit& visit = visits_[bend];
  return visit.stamp == stamp_ && visit.cost <= cost;
}

inline void RoadmapSearch::Impl::reach(std::uint32_t i, std::uint32_t j, double through) {
  visits_[j] = {through, i, stamp_};
  open_.push(
      {through + weight_ * (to_ - tiles_.bends()[j].position).norm(), through, j, Open::reached});
}

// Where the roadmap has no edges: those that matter, looked for.
void RoadmapSearch::Impl::look_around(std::uint32_t i, double cost, const Across& in) {
  const std::vector<Bend>& bends = tiles_.bends();
  const Bend& bend = bends[i];
  const double reach2 = reach_ * reach_;
  const Onward onward(bend, in);
  const auto skip = [&](const BendTree::Node& node) {
    return onward.misses(node) ||
           (!node.leaf && between_.hides(bend.position, BendTree::box(node)));
  };
  tree_->for_near(bend.position, reach_, skip, [&](std::uint32_t j) {
    const Bend& other = bends[j];
    const Vec3 d = other.position - bend.position;
    const double square = d.squaredNorm();
    if (j == i || square > reach2) return;
    if (!onward.goes(d) || !across(other, -d).tangent()) return;
    const double through = cost + std::sqrt(square);
    if (known_as_near(j, through)) return;
    if (!between_.hits(bend.position, other.position)) reach(i, j, through);
  });
}

// The edges that keep wrapping around the bend's box for a path that comes from `in`.
std::span<const std::uint32_t> RoadmapSearch::Impl::onward(std::uint32_t i, const Across& in,
                                                           const LoadedTiles::Edges& edges) {
  const Bend bend = tiles_.bends()[i];
  const auto ratio = [&](std::uint32_t edge) {
    const std::uint32_t j = tiles_.target(edges.tile, edge);
    return across(bend, tiles_.bends()[j].position - bend.position).ratio();
  };
  if (in.second_side()) {  // out on the first side, by at most as much
    const double most = in.ratio() + kLoose;
    const auto end = std::partition_point(edges.first.begin(), edges.first.end(),
                                          [&](std::uint32_t e) { return ratio(e) <= most; });
    return {edges.first.begin(), end};
  }
  const double least = in.ratio() - kLoose;  // by at least as much
  const auto begin = std::partition_point(edges.second.begin(), edges.second.end(),
                                          [&](std::uint32_t e) { return ratio(e) < least; });
  return {begin, edges.second.end()};
}

void RoadmapSearch::Impl::expand(std::uint32_t i, double cost, const Across& in) {
  const LoadedTiles::Edges edges = tiles_.edges_of(i);
  const Vec3 here = tiles_.bends()[i].position;
  const auto further = onward(i, in, edges);
  make_room();
  for (const std::uint32_t edge : further) {
    std::uint32_t j = tiles_.known_target(edges.tile, edge);
    if (j == LoadedTiles::kNotYet) {
      j = tiles_.target(edges.tile, edge);
      make_room();
    }
    const double through = cost + (tiles_.bends()[j].position - here).norm();
    if (!known_as_near(j, through)) reach(i, j, through);
  }
}

geom::Polyline RoadmapSearch::Impl::trace(std::uint32_t bend) const {
  geom::Polyline path = {to_};
  for (; bend != kStart; bend = visits_[bend].from) {
    path.push_back(tiles_.bends()[bend].position);
  }
  path.push_back(from_);
  std::reverse(path.begin(), path.end());
  return path;
}

bool RoadmapSearch::Impl::linked_to_start(std::uint32_t i) {
  const Vec3& bend = tiles_.bends()[i].position;
  if (hidden_from_start_ && hidden_from_start_->hides(bend)) return false;
  if (!from_start_.hits(from_, bend)) return true;
  if (++blocked_ == kBlind) hidden_from_start_.emplace(*scene_, from_);
  return false;
}

// Whether this is the shortest way to a bend that was not settled yet.
bool RoadmapSearch::Impl::settle(const Open& top) {
  const std::uint32_t i = top.index;
  if (top.kind == Open::unlinked) {
    if (known_as_near(i, top.cost)) return false;
    if (!linked_to_start(i)) return false;
    visits_[i] = {top.cost, kStart, stamp_};
  } else if (visits_[i].cost < top.cost) {
    return false;
  }
  visits_[i].cost = kSettled;
  return true;
}

Across RoadmapSearch::Impl::arrival(std::uint32_t i) const {
  const std::uint32_t before = visits_[i].from;
  const Vec3& back = before == kStart ? from_ : tiles_.bends()[before].position;
  return across(tiles_.bends()[i], back - tiles_.bends()[i].position);
}

// Whether a path that comes from `in` may end with the straight line to the goal.
bool RoadmapSearch::Impl::sees_goal(std::uint32_t i, const Across& in) {
  const Bend& bend = tiles_.bends()[i];
  const Across out = across(bend, to_ - bend.position);
  if (!out.tangent() || !wraps(in, out)) return false;
  if (hidden_from_goal_ && hidden_from_goal_->hides(bend.position)) return false;
  if (!to_goal_.hits(bend.position, to_)) return true;
  if (++unseen_ == kBlind) hidden_from_goal_.emplace(*scene_, to_);
  return false;
}

RoadmapResult RoadmapSearch::Impl::search(const Vec3& from, const Vec3& to,
                                          const RoadmapLimits& limits) {
  RoadmapResult result;
  begin(from, to, limits);
  const bool has_edges = source_ != nullptr;
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
    : impl_(std::make_unique<Impl>(scene, tiles_of(roadmap))) {}
RoadmapSearch::RoadmapSearch(const geom::CollisionScene& scene, RoadmapFill& fill)
    : impl_(std::make_unique<Impl>(scene, fill.source())) {}
RoadmapSearch::RoadmapSearch(const geom::CollisionScene& scene, std::vector<Bend> bends,
                             double reach)
    : impl_(std::make_unique<Impl>(scene, std::move(bends), reach)) {}
RoadmapSearch::~RoadmapSearch() = default;

RoadmapResult RoadmapSearch::search(const Vec3& from, const Vec3& to, const RoadmapLimits& limits) {
  return impl_->search(from, to, limits);
}

}  // namespace plan
