#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include "bend_lanes.h"
#include "bend_tree.h"
#include "bends.h"
#include "frontier.h"
#include "loaded_tiles.h"
#include "onward.h"
#include "path/last_blockers.h"
#include "plan/roadmap/roadmap.h"
#include "shadows.h"

namespace plan {
namespace {

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
  Impl(const geom::CollisionScene& scene, const Roadmap& roadmap)
      : scene_(&scene), roadmap_(&roadmap), tiles_(roadmap) {}
  Impl(const geom::CollisionScene& scene, std::vector<Bend> bends, double reach)
      : scene_(&scene),
        tree_(std::in_place, bends),
        lanes_(std::in_place, bends),
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
  void measure_to_goal();
  void open_node(std::uint32_t node);
  void push_node(std::uint32_t node);
  void make_room();
  bool settle(const Open& top);
  bool known_as_near(std::uint32_t bend, double cost) const;
  void reach(std::uint32_t from, std::uint32_t to, double cost, double on);
  void look_around(std::uint32_t bend, double cost, const Across& in);
  std::span<const std::uint32_t> onward(std::uint32_t bend, const Across& in,
                                        const LoadedTiles::Edges& edges);
  void expand(std::uint32_t bend, double cost, const Across& in);
  Across arrival(std::uint32_t bend) const;
  bool linked_to_start(std::uint32_t bend);
  bool sees_goal(std::uint32_t bend, const Across& in);
  geom::Polyline trace(std::uint32_t bend) const;

  const geom::CollisionScene* scene_;
  const Roadmap* roadmap_ = nullptr;  // none where there are no edges
  std::optional<BendTree> tree_;      // where there are no edges
  std::optional<BendLanes> lanes_;    // likewise
  LoadedTiles tiles_;
  double reach_ = 0;
  std::vector<double> bend_to_goal_;  // metres from each bend, where there are no edges,
  std::vector<double> node_to_goal_;  // and from each node of tree_
  std::vector<Visit> visits_;
  std::uint32_t stamp_ = 0;
  Frontier<LowestPlace> open_{LowestPlace{&tiles_}};
  Vec3 from_;
  Vec3 to_;
  double weight_ = 1;
  double shorter_ = 0;
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
  shorter_ = limits.shorter;
  blocked_ = 0;
  unseen_ = 0;
  hidden_from_start_.reset();
  hidden_from_goal_.reset();
  if (roadmap_ && (tiles_.bends().size() > kKept || tiles_.tiles() > kKeptTiles)) {
    tiles_ = LoadedTiles(*roadmap_);
    visits_.clear();
  }
  if (++stamp_ == 0) {
    std::fill(visits_.begin(), visits_.end(), Visit{});
    stamp_ = 1;
  }
  if (tree_) measure_to_goal();
  const double straight = (to - from).norm();
  open_.start(weight_ * straight, std::max(kBucket * weight_ * straight, 1e-6));
  if (!tiles_.empty()) push_node(tiles_.root());
}

// Nodes cost more than anything, so that they come before bends that tie with them.
void RoadmapSearch::Impl::push_node(std::uint32_t index) {
  const BendTree::Node& node = tiles_.node(index);
  const double from_start = BendTree::distance(node, from_);
  const double to_goal = BendTree::distance(node, to_);
  if (from_start + to_goal >= shorter_) return;
  const double bound = from_start + weight_ * to_goal;
  open_.push({bound, std::numeric_limits<double>::infinity(), index, Open::node});
}

// Where there are no edges: each is asked for often.
void RoadmapSearch::Impl::measure_to_goal() {
  bend_to_goal_.clear();
  for (const Bend& bend : tiles_.bends()) bend_to_goal_.push_back((to_ - bend.position).norm());
  bend_to_goal_.resize(tiles_.bends().size() + BendTree::kChildren);  // a look reads whole lanes
  node_to_goal_.clear();
  for (std::uint32_t n = 0; n < tree_->size(); ++n) {
    node_to_goal_.push_back(BendTree::distance(tree_->node(n), to_));
  }
  node_to_goal_.resize(tree_->size() + BendTree::kChildren);  // as above
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
    const double on = (to_ - bend.position).norm();
    if (cost + on >= shorter_) continue;
    open_.push({cost + weight_ * on, cost, i, Open::unlinked});
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

inline void RoadmapSearch::Impl::reach(std::uint32_t i, std::uint32_t j, double through,
                                       double on) {
  if (through + on >= shorter_) return;
  visits_[j] = {through, i, stamp_};
  open_.push({through + weight_ * on, through, j, Open::reached});
}

// Where the roadmap has no edges: those that matter, looked for.
void RoadmapSearch::Impl::look_around(std::uint32_t i, double cost, const Across& in) {
  const std::vector<Bend>& bends = tiles_.bends();
  const Bend& bend = bends[i];
  const Onward onward(bend, in);
  const Look look{bend.position, onward, reach_ * reach_, shorter_ - cost};
  const auto pick = [&](std::uint32_t n) {
    const unsigned mask = BendLanes::reached(*tree_, n, look, node_to_goal_.data());
    const bool hidden = mask != 0 && between_.hides(bend.position, BendTree::box(tree_->node(n)));
    return hidden ? 0 : mask;
  };
  std::array<double, BendTree::kBendsOfLeaf> squares;
  tree_->for_leaves(pick, [&](std::uint32_t first, std::uint32_t count) {
    unsigned mask = lanes_->reached(first, count, look, bend_to_goal_.data(), squares.data());
    for (; mask != 0; mask &= mask - 1) {
      const auto k = static_cast<std::uint32_t>(std::countr_zero(mask));
      const std::uint32_t j = first + k;
      const double through = cost + std::sqrt(squares[k]);
      if (through + bend_to_goal_[j] >= shorter_ || j == i || known_as_near(j, through)) continue;
      if (!between_.hits(bend.position, bends[j].position)) reach(i, j, through, bend_to_goal_[j]);
    }
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
    const Vec3& there = tiles_.bends()[j].position;
    const double through = cost + (there - here).norm();
    if (!known_as_near(j, through)) reach(i, j, through, (to_ - there).norm());
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
  const bool has_edges = roadmap_ != nullptr;
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
RoadmapSearch::RoadmapSearch(const geom::CollisionScene& scene, std::vector<Bend> bends,
                             double reach)
    : impl_(std::make_unique<Impl>(scene, std::move(bends), reach)) {}
RoadmapSearch::~RoadmapSearch() = default;

RoadmapResult RoadmapSearch::search(const Vec3& from, const Vec3& to, const RoadmapLimits& limits) {
  return impl_->search(from, to, limits);
}

}  // namespace plan
