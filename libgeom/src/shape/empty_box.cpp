#include "geom/shape/empty_box.h"

#include <algorithm>
#include <array>
#include <queue>
#include <set>
#include <vector>

#include "geom/base/error.h"

namespace geom {
namespace {

double volume(const Aabb& box) { return (box.max - box.min).prod(); }

std::array<double, 6> key(const Aabb& box) {
  return {box.min[0], box.min[1], box.min[2], box.max[0], box.max[1], box.max[2]};
}

// Whether the obstacle reaches into the interior.
bool reaches_into(const Aabb& box, const Aabb& obstacle) {
  return (obstacle.min.array() < box.max.array()).all() &&
         (obstacle.max.array() > box.min.array()).all();
}

// The obstacle to cut off next: the one that leaves least on its best side, so that the bound falls
// fast. Nothing where the interior is empty.
const Aabb* worst_inside(const Aabb& box, const Aabb& seed, std::span<const Aabb> obstacles);

// The parts of `box` beside the obstacle that keep the seed.
std::vector<Aabb> cuts(const Aabb& box, const Aabb& seed, const Aabb& obstacle) {
  std::vector<Aabb> out;
  for (int i = 0; i < 3; ++i) {
    if (obstacle.min[i] >= seed.max[i]) {
      out.push_back(box);
      out.back().max[i] = obstacle.min[i];
    }
    if (obstacle.max[i] <= seed.min[i]) {
      out.push_back(box);
      out.back().min[i] = obstacle.max[i];
    }
  }
  return out;
}

const Aabb* worst_inside(const Aabb& box, const Aabb& seed, std::span<const Aabb> obstacles) {
  const Aabb* worst = nullptr;
  double least = 0;
  for (const Aabb& obstacle : obstacles) {
    if (!reaches_into(box, obstacle)) continue;
    double best = 0;
    for (const Aabb& part : cuts(box, seed, obstacle)) best = std::max(best, volume(part));
    if (worst && best >= least) continue;
    worst = &obstacle;
    least = best;
  }
  return worst;
}

// Cuts off obstacle after obstacle where that costs least: an answer, not always the largest.
Aabb greedy(Aabb box, const Aabb& seed, std::span<const Aabb> obstacles) {
  while (const Aabb* worst = worst_inside(box, seed, obstacles)) {
    const auto parts = cuts(box, seed, *worst);
    box = *std::max_element(parts.begin(), parts.end(),
                            [](const Aabb& a, const Aabb& b) { return volume(a) < volume(b); });
  }
  return box;
}

}  // namespace

std::optional<EmptyBox> empty_box(const Aabb& seed, const Aabb& limits,
                                  std::span<const Aabb> obstacles, std::size_t most_cuts) {
  for (const Aabb& obstacle : obstacles) {
    if ((obstacle.min.array() <= obstacle.max.array()).all()) continue;
    throw InputError("obstacle",
                     {.expected = "min <= max on every axis", .found = "a box without"});
  }
  if (!contains(limits, seed.min) || !contains(limits, seed.max)) return std::nullopt;
  for (const Aabb& obstacle : obstacles) {
    if (overlap(seed, obstacle)) return std::nullopt;
  }
  struct State {
    double volume;
    std::size_t made;  // ties: the earlier
    Aabb box;
    bool operator<(const State& other) const {
      return volume != other.volume ? volume < other.volume : made > other.made;
    }
  };
  std::priority_queue<State> open;
  std::set<std::array<double, 6>> seen;
  open.push({volume(limits), 0, limits});
  std::size_t made = 1;
  while (made < most_cuts) {
    const State top = open.top();
    open.pop();
    const Aabb* worst = worst_inside(top.box, seed, obstacles);
    if (!worst) return EmptyBox{top.box, true};
    for (const Aabb& part : cuts(top.box, seed, *worst)) {
      if (seen.insert(key(part)).second) open.push({volume(part), made++, part});
    }
  }
  return EmptyBox{greedy(limits, seed, obstacles), false};
}

}  // namespace geom
