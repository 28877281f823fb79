#pragma once

// One of the lattices that a planner searches.

#include <memory>
#include <mutex>
#include <vector>

#include "plan/lattice/astar.h"
#include "plan/planner/plan.h"

namespace plan {

// A lattice, and workspaces for those who search on it. May be searched from several threads.
class LatticeLevel {
 public:
  // `given` by the user, and not made by the planner of its own scene.
  LatticeLevel(Lattice lattice, bool given) : lattice_(std::move(lattice)), given_(given) {}

  bool given() const { return given_; }

  // The path as the search found it, by AstarSearch with the weight, and what the search was in any
  // case.
  PlanResult search(const geom::CollisionScene& scene, const Vec3& from, const Vec3& to,
                    double weight);

 private:
  std::unique_ptr<AstarSearch> take();
  void give_back(std::unique_ptr<AstarSearch> search);

  const Lattice lattice_;
  bool given_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<AstarSearch>> idle_;
};

}  // namespace plan
