#include "plan/astar.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace plan {
namespace {

constexpr double kSqrt2 = 1.4142135623730951;
constexpr double kSqrt3 = 1.7320508075688772;

// Steps between two nodes without obstacles, in units of the spacing.
double unobstructed(Connectivity connectivity, const Index3& a, const Index3& b) {
  std::int64_t x = std::abs(a[0] - b[0]);
  std::int64_t y = std::abs(a[1] - b[1]);
  std::int64_t z = std::abs(a[2] - b[2]);
  if (connectivity == Connectivity::six) return static_cast<double>(x + y + z);
  if (x < y) std::swap(x, y);
  if (y < z) std::swap(y, z);
  if (x < y) std::swap(x, y);
  if (connectivity == Connectivity::twenty_six) {
    return static_cast<double>(x - y) + kSqrt2 * static_cast<double>(y - z) +
           kSqrt3 * static_cast<double>(z);
  }
  if (x >= y + z) return static_cast<double>(x - y - z) + kSqrt2 * static_cast<double>(y + z);
  const std::int64_t sum = x + y + z;
  return kSqrt2 * static_cast<double>(sum / 2) + static_cast<double>(sum % 2);
}

}  // namespace

bool AstarSearch::comes_later(const Open& a, const Open& b) {
  if (a.bound != b.bound) return a.bound > b.bound;
  return a.cost != b.cost ? a.cost < b.cost : a.node > b.node;
}

AstarSearch::AstarSearch(const Lattice& lattice) : lattice_(&lattice), visits_(lattice.size()) {}

double AstarSearch::to_goal(std::size_t node) const {
  const Index3 at = lattice_->index(node);
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < goals_.size(); ++i) {
    const double steps = unobstructed(lattice_->spec().connectivity, at, goal_index_[i]);
    best = std::min(best, steps * lattice_->spec().spacing + goals_[i].cost);
  }
  // Sums along a path round differently from this product; a hair less keeps it a lower bound.
  return best * (1 - 1e-12);
}

void AstarSearch::push(std::size_t node, double cost, int direction) {
  Visit& visit = visits_[node];
  if (visit.stamp == stamp_ && (visit.settled || visit.cost <= cost)) return;
  visit = {cost, stamp_, static_cast<std::int8_t>(direction), false};
  open_.push_back({cost + to_goal(node), cost, static_cast<std::uint32_t>(node)});
  std::push_heap(open_.begin(), open_.end(), comes_later);
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

SearchResult AstarSearch::search(std::span<const Terminal> sources,
                                 std::span<const Terminal> goals) {
  SearchResult result;
  open_.clear();
  goals_.assign(goals.begin(), goals.end());
  goal_index_.clear();
  for (const Terminal& goal : goals) goal_index_.push_back(lattice_->index(goal.node));
  if (goals.empty()) return result;
  if (++stamp_ == 0) {
    std::fill(visits_.begin(), visits_.end(), Visit{});
    stamp_ = 1;
  }
  for (const Terminal& source : sources) push(source.node, source.cost, -1);

  double best = std::numeric_limits<double>::infinity();
  std::size_t best_goal = 0;
  while (!open_.empty() && open_.front().bound < best) {
    std::pop_heap(open_.begin(), open_.end(), comes_later);
    const Open top = open_.back();
    open_.pop_back();
    Visit& visit = visits_[top.node];
    if (visit.settled || visit.cost < top.cost) continue;
    visit.settled = true;
    ++result.expanded;
    for (const Terminal& goal : goals_) {
      if (goal.node == top.node && top.cost + goal.cost < best) {
        best = top.cost + goal.cost;
        best_goal = top.node;
      }
    }
    std::uint32_t mask = lattice_->mask(top.node) & ~Lattice::kNode;
    for (; mask; mask &= mask - 1) {
      const int d = std::countr_zero(mask);
      push(static_cast<std::size_t>(top.node + lattice_->offset(d)),
           top.cost + lattice_->edge_length(d), d);
    }
  }
  if (best == std::numeric_limits<double>::infinity()) return result;
  result.found = true;
  result.cost = best;
  result.nodes = trace(best_goal);
  return result;
}

}  // namespace plan
