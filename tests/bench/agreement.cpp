// agreement N: compares N segment queries (random, street-level, lattice-aligned), and the lattices
// of 25 and 10 m, with rational arithmetic, and moves 1,000 proved trajectories into touch.

#include <fmt/format.h>

#include <cstdlib>

#include "geom/collision.h"
#include "plan/build_lattice.h"
#include "plan/plan.h"
#include "support/city.h"
#include "support/exact_oracle.h"
#include "support/random_city.h"
#include "traj/check.h"
#include "traj/solve.h"

namespace {

using geom::Vec3;

class Oracle {
 public:
  explicit Oracle(const geom::CollisionScene& scene) {
    for (std::size_t i = 0; i < scene.map().size(); ++i) grown_.push_back(scene.grown(i));
  }

  bool hits(const Vec3& a, const Vec3& b) const {
    const geom::Aabb around{a.cwiseMin(b), a.cwiseMax(b)};
    for (const geom::Aabb& box : grown_) {
      if (geom::overlap(box, around) && oracle::segment_hits(a, b, box)) return true;
    }
    return false;
  }

 private:
  std::vector<geom::Aabb> grown_;
};

Vec3 in_bounds(support::Random& random, const geom::Aabb& b, double ceiling) {
  return {random.uniform(b.min[0], b.max[0]), random.uniform(b.min[1], b.max[1]),
          random.uniform(b.min[2], std::min(b.max[2], ceiling))};
}

std::pair<Vec3, Vec3> segment_of_kind(support::Random& random, const geom::Aabb& b, int kind) {
  const Vec3 a = in_bounds(random, b, kind == 1 ? 30 : 1e9);
  if (kind == 2) {  // between nodes of a 5 m lattice on the lower corner, along and across
    Vec3 p = b.min + 5 * ((a - b.min) / 5).array().floor().matrix();
    const Vec3 d(random.below(3) - 1, random.below(3) - 1, random.below(3) - 1);
    return {p, p + d * 5 * (1 + random.below(6))};
  }
  const Vec3 d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-0.3, 0.3));
  return {a, a + d * random.uniform(5, 50)};
}

std::size_t compare_segments(const geom::CollisionScene& scene, const Oracle& exact,
                             std::size_t n) {
  support::Random random(1);
  std::size_t wrong = 0;
  std::size_t hits = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto [a, b] = segment_of_kind(random, scene.map().spec().bounds, static_cast<int>(i % 3));
    const bool hit = scene.hits(a, b);
    hits += hit;
    wrong += hit != exact.hits(a, b);
  }
  fmt::print("segments {} hits {} disagreements {}\n", n, hits, wrong);
  return wrong;
}

std::size_t compare_lattice(const geom::CollisionScene& scene, const Oracle& exact, double spacing,
                            plan::Connectivity connectivity) {
  const plan::Lattice lattice =
      plan::build_lattice(scene, {spacing, connectivity, scene.map().spec().bounds.min}, {2, {}});
  std::size_t wrong = 0;
  std::size_t edges = 0;
  for (std::size_t n = 0; n < lattice.size(); ++n) {
    const Vec3 p = lattice.position(n);
    wrong += lattice.free(n) == exact.hits(p, p);
    for (int d = 0; d < plan::half_directions(connectivity); ++d) {
      plan::Index3 to = lattice.index(n);
      for (int k = 0; k < 3; ++k) to[k] += plan::kDirection[d][k];
      const auto other = lattice.node(to);
      if (!other) continue;
      ++edges;
      wrong += ((lattice.mask(n) >> d & 1) != 0) == exact.hits(p, lattice.position(*other));
    }
  }
  fmt::print("lattice {} m, {} neighbours: nodes {} edges {} wrong {}\n", spacing,
             static_cast<int>(connectivity), lattice.size(), edges, wrong);
  return wrong;
}

// A known point of each curve is put on a face of a real obstacle's growth, or up to 1 cm inside.
std::size_t move_into_touch(const geom::CollisionScene& scene) {
  plan::Planner planner(scene, nullptr, {2, {}});
  support::Random random(5);
  const traj::Limits limits{8, 6, {}, {}};
  std::size_t originals = 0;
  std::size_t missed = 0;
  while (originals < 1000) {
    const geom::Aabb& b = *scene.free_bounds();
    const Vec3 from = in_bounds(random, b, 40);
    const Vec3 to =
        from + Vec3(random.uniform(-60, 60), random.uniform(-60, 60), random.uniform(-5, 5));
    const plan::PlanResult path = planner.plan(from, to, {});
    if (path.status != plan::PlanStatus::found) continue;
    const traj::Solver solver = originals % 2 ? traj::Solver::automatic : traj::Solver::stop_and_go;
    const traj::SolveResult solved = traj::solve(scene, path.path, {limits, solver, 1e-3, 200});
    if (solved.status != traj::SolveStatus::solved ||
        !traj::check(scene, solved.trajectory, limits).ok) {
      ++missed;
      continue;
    }
    traj::Trajectory moved = solved.trajectory;
    const Vec3 p = traj::evaluate(moved, random.uniform(0, traj::duration(moved))).position;
    const geom::Aabb box = scene.map().boxes()[random.below(static_cast<int>(scene.map().size()))];
    const int axis = random.below(3);
    Vec3 target = 0.5 * (box.min + box.max);
    const double depth = originals % 3 ? random.uniform(0, 0.01) : 0;
    target[axis] = box.max[axis] + scene.half()[axis] - depth;
    for (traj::Segment& s : moved.segments) {
      for (Vec3& q : s.point) q += target - p;
    }
    missed += traj::check(scene, moved, limits).ok;
    ++originals;
  }
  fmt::print("trajectories moved into touch {} wrong {}\n", originals, missed);
  return missed;
}

}  // namespace

int main(int argc, char** argv) {
  const auto n = static_cast<std::size_t>(argc > 1 ? std::atof(argv[1]) : 1e5);
  const geom::CollisionScene scene(support::load_city(support::city_file()), {"box", {1, 1, 1}}, 0);
  const Oracle exact(scene);
  std::size_t wrong = compare_segments(scene, exact, n);
  for (const double spacing : {25.0, 10.0}) {
    for (const auto connectivity : {plan::Connectivity::six, plan::Connectivity::twenty_six}) {
      wrong += compare_lattice(scene, exact, spacing, connectivity);
    }
  }
  wrong += move_into_touch(scene);
  return wrong != 0;
}
