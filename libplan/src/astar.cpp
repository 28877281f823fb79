#include "plan/astar.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

namespace plan {
namespace {

// 2^27 edges in a row still fit into 64 bits, and a lattice has at most 2^31 nodes.
constexpr double kOne = 0x1p36;
constexpr std::uint64_t kAxis = 1ull << 36;
constexpr std::uint64_t kSqrt2 = 97184015999;   // round(2^36 sqrt 2)
constexpr std::uint64_t kSqrt3 = 119025625176;  // round(2^36 sqrt 3)
constexpr std::size_t kFewGoals = 16;  // beyond, the least of all their distances costs too much
constexpr std::uint64_t kNone = std::numeric_limits<std::uint64_t>::max();

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

bool AstarSearch::earlier(const Open& a, const Open& b) {
  if (a.bound != b.bound) return a.bound < b.bound;
  return a.cost != b.cost ? a.cost > b.cost : a.node < b.node;
}

AstarSearch::AstarSearch(const Lattice& lattice) : lattice_(&lattice), visits_(lattice.size()) {
  constexpr std::uint64_t kLengths[] = {0, kAxis, kSqrt2, kSqrt3};
  for (int d = 0; d < kDirections; ++d) {
    const auto& [dx, dy, dz] = kDirection[d];
    step_[d] = kLengths[std::abs(dx) + std::abs(dy) + std::abs(dz)];
  }
}

AstarSearch::Units AstarSearch::units(double metres) const {
  const double steps = metres / lattice_->spec().spacing;
  assert(steps >= 0 && steps < 0x1p20);
  return static_cast<Units>(std::llround(steps * kOne));
}

AstarSearch::Units AstarSearch::to_goal(std::int32_t x, std::int32_t y, std::int32_t z) const {
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

// Clamping moves no coordinate further than the step does, so this is consistent too.
AstarSearch::Units AstarSearch::to_box(std::int32_t x, std::int32_t y, std::int32_t z) const {
  const auto apart = [](std::int32_t v, std::int32_t low, std::int32_t high) {
    return static_cast<std::uint64_t>(std::max({low - v, v - high, 0}));
  };
  return lowest_.cost + unobstructed(lattice_->spec().connectivity, apart(x, lowest_.x, highest_.x),
                                     apart(y, lowest_.y, highest_.y),
                                     apart(z, lowest_.z, highest_.z));
}

const AstarSearch::Goal* AstarSearch::goal_at(std::uint32_t node) const {
  const auto by_node = [](const Goal& goal, std::uint32_t n) { return goal.node < n; };
  const auto at = std::lower_bound(goals_.begin(), goals_.end(), node, by_node);
  return at != goals_.end() && at->node == node ? &*at : nullptr;
}

// The earliest entry is kept beside the heap while nothing else is taken: a search that runs
// straight on takes what it has just put in.
void AstarSearch::insert(const Open& entry) {
  if (!has_next_ && (open_.empty() || earlier(entry, open_.front()))) {
    next_ = entry;
    has_next_ = true;
    return;
  }
  if (has_next_ && earlier(entry, next_)) {
    push_heap(std::exchange(next_, entry));
    return;
  }
  push_heap(entry);
}

void AstarSearch::push_heap(const Open& entry) {
  std::size_t at = open_.size();
  open_.push_back(entry);
  while (at > 0) {
    const std::size_t parent = (at - 1) / 4;
    if (!earlier(entry, open_[parent])) break;
    open_[at] = open_[parent];
    at = parent;
  }
  open_[at] = entry;
}

AstarSearch::Open AstarSearch::take_first() {
  if (has_next_) {
    has_next_ = false;
    return next_;
  }
  const Open first = open_.front();
  const Open last = open_.back();
  open_.pop_back();
  const std::size_t n = open_.size();
  if (n == 0) return first;
  std::size_t at = 0;
  for (std::size_t child = 1; child < n; child = 4 * at + 1) {
    std::size_t least = child;
    for (std::size_t c = child + 1; c < std::min(child + 4, n); ++c) {
      if (earlier(open_[c], open_[least])) least = c;
    }
    if (!earlier(open_[least], last)) break;
    open_[at] = open_[least];
    at = least;
  }
  open_[at] = last;
  return first;
}

void AstarSearch::push(std::uint32_t node, Units cost, int direction, std::int32_t x,
                       std::int32_t y, std::int32_t z) {
  Visit& visit = visits_[node];
  if (visit.stamp == stamp_ && (visit.settled || visit.cost <= cost)) return;
  visit = {cost, stamp_, static_cast<std::int8_t>(direction), false};
  insert({cost + to_goal(x, y, z), cost, node});
}

void AstarSearch::expand(const Open& from) {
  const auto nx = static_cast<std::uint32_t>(lattice_->dims()[0]);
  const auto ny = static_cast<std::uint32_t>(lattice_->dims()[1]);
  const auto x = static_cast<std::int32_t>(from.node % nx);
  const auto y = static_cast<std::int32_t>(from.node / nx % ny);
  const auto z = static_cast<std::int32_t>(from.node / nx / ny);
  std::uint32_t mask = lattice_->mask(from.node) & ~Lattice::kNode;
  for (; mask; mask &= mask - 1) {
    const int d = std::countr_zero(mask);
    const auto& [dx, dy, dz] = kDirection[d];
    push(static_cast<std::uint32_t>(from.node + lattice_->offset(d)), from.cost + step_[d], d,
         x + dx, y + dy, z + dz);
  }
}

void AstarSearch::start(std::span<const Terminal> sources, std::span<const Terminal> goals) {
  open_.clear();
  has_next_ = false;
  goals_.clear();
  if (++stamp_ == 0) {
    std::fill(visits_.begin(), visits_.end(), Visit{});
    stamp_ = 1;
  }
  const auto at = [&](std::size_t node, int axis) {
    return static_cast<std::int32_t>(lattice_->index(node)[axis]);
  };
  for (const Terminal& goal : goals) {
    const std::size_t n = goal.node;
    goals_.push_back(
        {at(n, 0), at(n, 1), at(n, 2), static_cast<std::uint32_t>(n), units(goal.cost), goal.cost});
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
    const std::size_t n = source.node;
    push(static_cast<std::uint32_t>(n), units(source.cost), -1, at(n, 0), at(n, 1), at(n, 2));
  }
}

std::vector<std::size_t> AstarSearch::trace(std::size_t node) const {
  std::vector<std::size_t> nodes = {node};
  while (visits_[node].arrived_by >= 0) {
    node = static_cast<std::size_t>(static_cast<std::int64_t>(node) -
                                    lattice_->offset(visits_[node].arrived_by));
    nodes.push_back(node);
  }
  std::reverse(nodes.begin(), nodes.end());
  return nodes;
}

double AstarSearch::metres(std::span<const std::size_t> nodes) const {
  double sum = 0;
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    sum += lattice_->edge_length(visits_[nodes[i]].arrived_by);
  }
  return sum;
}

SearchResult AstarSearch::search(std::span<const Terminal> sources,
                                 std::span<const Terminal> goals) {
  SearchResult result;
  start(sources, goals);
  Units best = kNone;
  const Goal* reached = nullptr;
  while ((has_next_ || !open_.empty()) && (has_next_ ? next_ : open_.front()).bound < best) {
    const Open top = take_first();
    Visit& visit = visits_[top.node];
    if (visit.settled) continue;
    visit.settled = true;
    ++result.expanded;
    const Goal* goal = goal_at(top.node);
    if (goal && top.cost + goal->cost < best) {
      best = top.cost + goal->cost;
      reached = goal;
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

}  // namespace plan
