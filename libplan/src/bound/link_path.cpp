#include "link_path.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <tuple>

#include "chain_path.h"

namespace plan {
namespace {

constexpr std::size_t kAskedSteps = 4;
constexpr std::uint32_t kNone = ~std::uint32_t{0};

// A leg to a part, not asked of the scene yet.
struct Leg {
  double least;  // of a path by it
  std::uint32_t to;
  std::uint32_t from;
  double length;  // of the path up to `to`

  friend bool operator>(const Leg& a, const Leg& b) {
    return std::tie(a.least, a.to, a.from) > std::tie(b.least, b.to, b.from);
  }
};

geom::Polyline traced(const std::vector<Vec3>& places, const std::vector<std::uint32_t>& parents) {
  geom::Polyline path;
  for (std::uint32_t i = kGoal; i != kStart; i = parents[i]) path.push_back(places[i]);
  path.push_back(places[kStart]);
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace

geom::Polyline link_path(const geom::CollisionScene& scene, const Level& level,
                         const std::vector<LineLabel>& go, double limit, std::size_t most,
                         std::size_t& steps) {
  std::vector<Vec3> places;
  for (const EdgePart& part : level.parts) places.push_back(beside_middle(part));
  std::vector<std::uint32_t> parents(places.size(), kNone);
  std::priority_queue<Leg, std::vector<Leg>, std::greater<>> queue;
  const auto think_of_legs = [&](std::uint32_t from, double length) {
    for (const Link& link : level.links[from]) {
      if (link.sight == Sight::hidden || parents[link.to] != kNone) continue;
      ++steps;
      const double to = length + (places[link.to] - places[from]).norm();
      const double all = to + least(go, link.to);
      if (all < limit) queue.push({all, link.to, from, to});
    }
  };
  const std::size_t end = steps + most;
  parents[kStart] = kStart;
  think_of_legs(kStart, 0);
  while (!queue.empty() && steps < end) {
    const Leg leg = queue.top();
    queue.pop();
    if (parents[leg.to] != kNone) continue;
    steps += kAskedSteps;
    if (!scene.free(places[leg.from], places[leg.to])) continue;
    parents[leg.to] = leg.from;
    if (leg.to == kGoal) return traced(places, parents);
    think_of_legs(leg.to, leg.length);
  }
  return {};
}

}  // namespace plan
