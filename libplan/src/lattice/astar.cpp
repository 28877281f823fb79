#include "plan/lattice/astar.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

#include "geom/base/error.h"
#include "heap.h"
#include "search_pages.h"

namespace plan {
namespace {

// A length fits into 64 bits below 2^28 edges. A path found has fewer than 2^25: a search sees at
// most the blocks kept from earlier searches and about kMostPages new ones, 512 nodes each. The
// heuristic counts at most as many edges as the three dims of the lattice together, and its weight
// at most doubles it.
constexpr double kOne = 0x1p36;
constexpr std::uint64_t kAxis = 1ull << 36;
constexpr std::uint64_t kSqrt2 = 97184015999;   // round(2^36 sqrt 2)
constexpr std::uint64_t kSqrt3 = 119025625176;  // round(2^36 sqrt 3)
constexpr std::size_t kFewGoals = 16;  // beyond, the least of all their distances costs too much
constexpr std::uint64_t kNone = std::numeric_limits<std::uint64_t>::max();

constexpr int kWeightBits = 10;
constexpr std::size_t kMostPages = std::size_t{1} << 14;  // that a search may add
constexpr std::size_t kQuiet = 1000;  // nodes expanded before the goals are flooded

// The length of the shortest way over x, y, z nodes along the axes, without obstacles.
std::uint64_t unobstructed(Connectivity connectivity, std::uint64_t x, std::uint64_t y,
                           std::uint64_t z) {
  if (connectivity == Connectivity::six) return (x + y + z) * kAxis;
  if (x < y) std::swap(x, y);
  if (y < z) std::swap(y, z);
  if (x < y) std::swap(x, y);
  if (connectivity == Connectivity::twenty_six) {
    return (x - y) * kAxis + (y - z) * kSqrt2 + z * kSqrt3;
  }
  if (x >= y + z) return (x - y - z) * kAxis + (y + z) * kSqrt2;
  return (x + y + z) / 2 * kSqrt2 + (x + y + z) % 2 * kAxis;
}

}  // namespace

struct AstarSearch::Impl {
  explicit Impl(const Lattice& lattice);

  SearchResult search(std::span<const Terminal> sources, std::span<const Terminal> goals,
                      double weight);
  bool free(const Index3& node);

  using Units = std::uint64_t;
  using Handle = NodeHandle;
  using Page = SearchPages::Page;
  using Place = SearchPages::Place;

  struct Open {
    Units bound;
    Units cost;
    Handle node;
  };
  struct Goal {
    std::int32_t x, y, z;
    Handle node;
    Units cost;
    double metres;
  };
  static bool earlier(const Open& a, const Open& b);
  void start(std::span<const Terminal> sources, std::span<const Terminal> goals);
  void expand(const Open& from);
  void push(Handle node, Units cost, int direction, std::int32_t x, std::int32_t y, std::int32_t z);
  void insert(const Open& entry);
  void add(const Open& entry);
  Open take_first();
  void flood(Handle node);
  void flood_next();
  bool goals_cut_off() const { return flooding_ && flood_next_ == flooded_.size(); }
  Units to_goal(std::int32_t x, std::int32_t y, std::int32_t z) const;
  Units weighted(Units to_goal) const;
  Units to_box(std::int32_t x, std::int32_t y, std::int32_t z) const;
  const Goal* goal_at(Handle node) const;
  Units units(double metres) const;
  std::vector<std::size_t> trace(Handle node);
  double metres(std::span<const std::size_t> nodes) const;

  const Lattice* lattice_;
  SearchPages pages_;
  std::vector<Open> open_;  // a heap
  Open next_{};             // earlier than all of the heap, where there is one
  bool has_next_ = false;
  std::vector<Goal> goals_;  // by node, the cheapest of each
  Goal lowest_{};            // the box around the goals, and the least cost of any
  Goal highest_{};
  std::array<Units, kDirections> step_;
  Units more_ = 0;  // what the heuristic weighs beyond 1, in 2^-kWeightBits
  std::uint32_t stamp_ = 0;
  std::vector<Handle> flooded_;  // from the goals, in the order met
  std::size_t flood_next_ = 0;
  bool flooding_ = false;  // until the flood meets the search
};

inline bool AstarSearch::Impl::earlier(const Open& a, const Open& b) {
  if (a.bound != b.bound) return a.bound < b.bound;
  return a.cost != b.cost ? a.cost > b.cost : a.node < b.node;
}

AstarSearch::Impl::Impl(const Lattice& lattice) : lattice_(&lattice), pages_(lattice) {
  constexpr std::uint64_t kLengths[] = {0, kAxis, kSqrt2, kSqrt3};
  for (int d = 0; d < kDirections; ++d) {
    const auto& [dx, dy, dz] = kDirection[d];
    step_[d] = kLengths[std::abs(dx) + std::abs(dy) + std::abs(dz)];
  }
}

bool AstarSearch::Impl::free(const Index3& node) {
  const Handle at = pages_.handle(node);
  return (pages_.page_of(at).masks[SearchPages::local(at)] & Lattice::kNode) != 0;
}

AstarSearch::Impl::Units AstarSearch::Impl::units(double metres) const {
  const double steps = metres / lattice_->spec().spacing;
  assert(steps >= 0 && steps < 0x1p20);
  return static_cast<Units>(std::llround(steps * kOne));
}

AstarSearch::Impl::Units AstarSearch::Impl::to_goal(std::int32_t x, std::int32_t y,
                                                    std::int32_t z) const {
  if (goals_.size() > kFewGoals) return to_box(x, y, z);
  const Connectivity connectivity = lattice_->spec().connectivity;
  Units best = kNone;
  for (const Goal& goal : goals_) {
    const auto apart = [](std::int32_t a, std::int32_t b) {
      return static_cast<std::uint64_t>(std::abs(a - b));
    };
    const Units way =
        unobstructed(connectivity, apart(x, goal.x), apart(y, goal.y), apart(z, goal.z));
    best = std::min(best, way + goal.cost);
  }
  return best;
}

// What is cut off is less than the 2^-10 of an edge that a weight is rounded to.
AstarSearch::Impl::Units AstarSearch::Impl::weighted(Units to_goal) const {
  return to_goal + (to_goal >> kWeightBits) * more_;
}

// Clamping moves no coordinate further than the step does, so this is consistent too.
AstarSearch::Impl::Units AstarSearch::Impl::to_box(std::int32_t x, std::int32_t y,
                                                   std::int32_t z) const {
  const auto apart = [](std::int32_t v, std::int32_t low, std::int32_t high) {
    return static_cast<std::uint64_t>(std::max({low - v, v - high, 0}));
  };
  return lowest_.cost + unobstructed(lattice_->spec().connectivity, apart(x, lowest_.x, highest_.x),
                                     apart(y, lowest_.y, highest_.y),
                                     apart(z, lowest_.z, highest_.z));
}

const AstarSearch::Impl::Goal* AstarSearch::Impl::goal_at(Handle node) const {
  const auto by_node = [](const Goal& goal, Handle n) { return goal.node < n; };
  const auto at = std::lower_bound(goals_.begin(), goals_.end(), node, by_node);
  return at != goals_.end() && at->node == node ? &*at : nullptr;
}

void AstarSearch::Impl::add(const Open& entry) {
  heap_push(open_, entry, [](const Open& a, const Open& b) { return earlier(a, b); });
}

// The earliest entry is kept beside the heap while nothing else is taken: a search that runs
// straight on takes what it has just put in.
void AstarSearch::Impl::insert(const Open& entry) {
  if (!has_next_ && (open_.empty() || earlier(entry, open_.front()))) {
    next_ = entry;
    has_next_ = true;
    return;
  }
  if (has_next_ && earlier(entry, next_)) {
    add(std::exchange(next_, entry));
    return;
  }
  add(entry);
}

AstarSearch::Impl::Open AstarSearch::Impl::take_first() {
  if (!has_next_)
    return heap_pop(open_, [](const Open& a, const Open& b) { return earlier(a, b); });
  has_next_ = false;
  return next_;
}

void AstarSearch::Impl::push(Handle node, Units cost, int direction, std::int32_t x, std::int32_t y,
                             std::int32_t z) {
  NodeVisit& visit = pages_.visit(node);
  if (visit.stamp == stamp_ && (visit.settled || visit.cost <= cost)) return;
  visit = {cost, stamp_, static_cast<std::int8_t>(direction), false};
  insert({cost + weighted(to_goal(x, y, z)), cost, node});
}

void AstarSearch::Impl::expand(const Open& from) {
  Page& page = pages_.page_of(from.node);
  const Place place = SearchPages::place_of(from.node);
  for (std::uint32_t mask = pages_.edges(from.node); mask; mask &= mask - 1) {
    const int d = std::countr_zero(mask);
    const auto& [dx, dy, dz] = kDirection[static_cast<std::size_t>(d)];
    push(pages_.neighbour(from.node, page, place, d), from.cost + step_[d], d,
         page.low.x + place.x + dx, page.low.y + place.y + dy, page.low.z + place.z + dz);
  }
}

// Marks a node as reached from the goals; where the search has been too, the goals are in reach.
void AstarSearch::Impl::flood(Handle node) {
  Page& page = pages_.page_of(node);
  const std::size_t local = SearchPages::local(node);
  if (page.visits[local].stamp == stamp_) {
    flooding_ = false;
    return;
  }
  if (page.flood_stamp != stamp_) {
    page.flood_stamp = stamp_;
    page.flooded.reset();
  }
  if (page.flooded[local]) return;
  page.flooded[local] = true;
  flooded_.push_back(node);
}

void AstarSearch::Impl::flood_next() {
  const Handle from = flooded_[flood_next_++];
  Page& page = pages_.page_of(from);
  const Place place = SearchPages::place_of(from);
  for (std::uint32_t mask = pages_.edges(from); mask && flooding_; mask &= mask - 1) {
    flood(pages_.neighbour(from, page, place, std::countr_zero(mask)));
  }
}

void AstarSearch::Impl::start(std::span<const Terminal> sources, std::span<const Terminal> goals) {
  open_.clear();
  has_next_ = false;
  goals_.clear();
  flooded_.clear();
  flood_next_ = 0;
  flooding_ = false;
  if (++stamp_ == 0 || pages_.size() > kMostPages) {
    pages_.clear();
    stamp_ = 1;
  }
  const auto at = [&](const Index3& i, std::size_t k) { return static_cast<std::int32_t>(i[k]); };
  for (const Terminal& goal : goals) {
    const Index3 i = lattice_->index(goal.node);
    goals_.push_back({at(i, 0), at(i, 1), at(i, 2), pages_.handle(i), units(goal.cost), goal.cost});
  }
  if (goals_.empty()) return;
  std::sort(goals_.begin(), goals_.end(), [](const Goal& a, const Goal& b) {
    return a.node != b.node ? a.node < b.node : a.metres < b.metres;
  });
  lowest_ = highest_ = goals_.front();
  for (const Goal& goal : goals_) {
    lowest_.x = std::min(lowest_.x, goal.x);
    lowest_.y = std::min(lowest_.y, goal.y);
    lowest_.z = std::min(lowest_.z, goal.z);
    lowest_.cost = std::min(lowest_.cost, goal.cost);
    highest_.x = std::max(highest_.x, goal.x);
    highest_.y = std::max(highest_.y, goal.y);
    highest_.z = std::max(highest_.z, goal.z);
  }
  for (const Terminal& source : sources) {
    const Index3 i = lattice_->index(source.node);
    push(pages_.handle(i), units(source.cost), -1, at(i, 0), at(i, 1), at(i, 2));
  }
}

std::vector<std::size_t> AstarSearch::Impl::trace(Handle node) {
  const Place& low = pages_.page_of(node).low;
  const Place place = SearchPages::place_of(node);
  Index3 i = {low.x + place.x, low.y + place.y, low.z + place.z};
  std::vector<std::size_t> nodes;
  while (true) {
    nodes.push_back(lattice_->node(i).value());
    const int d = pages_.visit(pages_.handle(i)).arrived_by;
    if (d < 0) break;
    for (std::size_t k = 0; k < 3; ++k) i[k] -= kDirection[static_cast<std::size_t>(d)][k];
  }
  std::reverse(nodes.begin(), nodes.end());
  return nodes;
}

double AstarSearch::Impl::metres(std::span<const std::size_t> nodes) const {
  double sum = 0;
  for (std::size_t n = 1; n < nodes.size(); ++n) {
    const Index3 a = lattice_->index(nodes[n - 1]);
    const Index3 b = lattice_->index(nodes[n]);
    std::int64_t axes = 0;
    for (std::size_t k = 0; k < 3; ++k) axes += std::abs(b[k] - a[k]);
    sum += lattice_->spec().spacing * std::sqrt(static_cast<double>(axes));
  }
  return sum;
}

SearchResult AstarSearch::Impl::search(std::span<const Terminal> sources,
                                       std::span<const Terminal> goals, double weight) {
  SearchResult result;
  if (!(weight >= 1 && weight <= 2)) {
    throw geom::InputError("weight", {.expected = "from 1 to 2", .found = fmt::to_string(weight)});
  }
  more_ = static_cast<Units>(std::llround((weight - 1) * (1 << kWeightBits)));
  start(sources, goals);
  const std::size_t before = pages_.size();
  Units best = kNone;
  const Goal* reached = nullptr;
  while ((has_next_ || !open_.empty()) && (has_next_ ? next_ : open_.front()).bound < best) {
    const Open top = take_first();
    NodeVisit& visit = pages_.visit(top.node);
    if (visit.settled) continue;
    visit.settled = true;
    if (++result.expanded == kQuiet && !reached) {
      flooding_ = true;
      for (const Goal& goal : goals_) flood(goal.node);
    }
    if (flooding_ && flood_next_ < flooded_.size()) flood_next();
    if (goals_cut_off()) return result;
    if (pages_.size() > before + kMostPages) {
      result.gave_up = true;
      return result;
    }
    const Goal* goal = goal_at(top.node);
    if (goal && top.cost + goal->cost < best) {
      best = top.cost + goal->cost;
      reached = goal;
      flooding_ = false;
    }
    if (best > top.bound) expand(top);
  }
  if (!reached) return result;
  result.found = true;
  result.nodes = trace(reached->node);
  double joined = std::numeric_limits<double>::infinity();
  for (const Terminal& source : sources) {
    if (source.node == result.nodes.front()) joined = std::min(joined, source.cost);
  }
  result.cost = joined + metres(result.nodes) + reached->metres;
  return result;
}

AstarSearch::AstarSearch(const Lattice& lattice) : impl_(std::make_unique<Impl>(lattice)) {}
AstarSearch::~AstarSearch() = default;
AstarSearch::AstarSearch(AstarSearch&&) noexcept = default;
AstarSearch& AstarSearch::operator=(AstarSearch&&) noexcept = default;

SearchResult AstarSearch::search(std::span<const Terminal> sources, std::span<const Terminal> goals,
                                 double weight) {
  return impl_->search(sources, goals, weight);
}

bool AstarSearch::free(const Index3& node) { return impl_->free(node); }

}  // namespace plan
