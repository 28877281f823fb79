#include "lattice_level.h"

#include <algorithm>

#include "plan/lattice/visible_nodes.h"

namespace plan {
namespace {

geom::Polyline joined(const Lattice& lattice, const Vec3& from,
                      const std::vector<std::size_t>& nodes, const Vec3& to) {
  geom::Polyline path = {from};
  for (const std::size_t node : nodes) path.push_back(lattice.position(node));
  path.push_back(to);
  path.erase(std::unique(path.begin(), path.end()), path.end());
  if (path.size() == 1) path.push_back(to);
  return path;
}

}  // namespace

std::unique_ptr<AstarSearch> LatticeLevel::take() {
  const std::lock_guard lock(mutex_);
  if (idle_.empty()) return std::make_unique<AstarSearch>(lattice_);
  auto search = std::move(idle_.back());
  idle_.pop_back();
  return search;
}

void LatticeLevel::give_back(std::unique_ptr<AstarSearch> search) {
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(search));
}

PlanResult LatticeLevel::search(const geom::CollisionScene& scene, const Vec3& from, const Vec3& to,
                                double weight) {
  PlanResult result;
  result.route = OwnRoute::lattice;
  result.resolution = lattice_.spec().spacing;
  auto search = take();
  SearchResult found;
  // The nearest nodes may lie in a pocket that the lattice cannot leave, though the end itself can.
  for (const Rings rings : {Rings::nearest, Rings::all}) {
    found = search->search(visible_nodes(scene, lattice_, *search, from, rings),
                           visible_nodes(scene, lattice_, *search, to, rings), weight);
    result.expanded += found.expanded;
    if (found.found || found.gave_up) break;
  }
  give_back(std::move(search));
  if (found.gave_up) result.status = PathStatus::stopped;
  if (!found.found) return result;
  result.status = PathStatus::found;
  result.path = joined(lattice_, from, found.nodes, to);
  return result;
}

}  // namespace plan
