// agreement N: compares N segment queries (random, street-level, lattice-aligned, grazing, of no
// length, inside obstacles, huge) on the map at its place and 100 and 500 km away, and the lattices
// of 25 and 10 m, with rational arithmetic, and moves 1,000 proved trajectories into touch.

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <numeric>

#include "geom/base/parallel.h"
#include "geom/collision/collision.h"
#include "geom/map/join.h"
#include "plan/lattice/build_lattice.h"
#include "plan/planner/plan.h"
#include "support/city.h"
#include "support/exact_oracle.h"
#include "support/random_city.h"
#include "traj/proof/check.h"
#include "traj/solve/solve.h"

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

constexpr int kKinds = 7;

std::pair<Vec3, Vec3> segment_of_kind(support::Random& random, const geom::CollisionScene& scene,
                                      int kind) {
  const geom::Aabb& b = scene.map().spec().bounds;
  const Vec3 a = in_bounds(random, b, kind == 1 ? 30 : 1e9);
  const Vec3 d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-0.3, 0.3));
  const auto box = [&] {
    return scene.grown(
        static_cast<std::size_t>(random.below(static_cast<int>(scene.map().size()))));
  };
  const auto inside = [&](const geom::Aabb& in) {
    return Vec3(random.uniform(in.min[0], in.max[0]), random.uniform(in.min[1], in.max[1]),
                random.uniform(in.min[2], in.max[2]));
  };
  switch (kind) {
    case 2: {  // between nodes of a 5 m lattice on the lower corner, along and across
      const Vec3 p = b.min + 5 * ((a - b.min) / 5).array().floor().matrix();
      const Vec3 step(random.below(3) - 1, random.below(3) - 1, random.below(3) - 1);
      return {p, p + step * 5 * (1 + random.below(6))};
    }
    case 3: {  // along a face or an edge, on it or one unit in the last place off
      const geom::Aabb one = box();
      Vec3 p = inside(one);
      Vec3 q = p + 30 * d;
      for (int axis = 0; axis < 1 + random.below(2); ++axis) {
        double at = random.below(2) ? one.min[axis] : one.max[axis];
        if (random.below(2)) at = std::nextafter(at, random.below(2) ? -1e9 : 1e9);
        p[axis] = q[axis] = at;
      }
      return {p, q};
    }
    case 4:
      return {a, a};
    case 5: {
      const geom::Aabb one = box();
      return {inside(one), inside(one)};
    }
    case 6:
      return {a, a + d * random.uniform(2e3, 2e4)};
    default:
      return {a, a + d * random.uniform(5, 50)};
  }
}

// The map, shifted: its coordinates rounded anew.
geom::BoxMap shifted(const geom::BoxMap& map, const Vec3& by) {
  geom::BoxTable table = geom::table_of(map);
  for (geom::Aabb& box : table.boxes) box = {box.min + by, box.max + by};
  geom::BoxMapSpec spec = map.spec();
  spec.bounds = {spec.bounds.min + by, spec.bounds.max + by};
  return {spec, table};
}

std::size_t compare_segments(const geom::BoxMap& map, double offset, std::size_t n) {
  constexpr std::size_t kBatch = 1000;
  const geom::CollisionScene scene(shifted(map, {offset, -offset, 0}), {"box", {1, 1, 1}}, 0);
  const Oracle exact(scene);
  std::vector<std::size_t> wrong((n + kBatch - 1) / kBatch);
  std::vector<std::size_t> hits(wrong.size());
  geom::parallel_for(wrong.size(), {2, {}}, [&](std::size_t batch) {
    support::Random random(1 + batch);
    for (std::size_t i = 0; i < std::min(kBatch, n - batch * kBatch); ++i) {
      const auto [a, b] = segment_of_kind(random, scene, static_cast<int>(i % kKinds));
      const bool hit = scene.hits(a, b);
      hits[batch] += hit;
      wrong[batch] += hit != exact.hits(a, b);
    }
  });
  const std::size_t all_wrong = std::accumulate(wrong.begin(), wrong.end(), std::size_t{0});
  fmt::print("{:.0f} km away: segments {} hits {} disagreements {}\n", offset / 1000, n,
             std::accumulate(hits.begin(), hits.end(), std::size_t{0}), all_wrong);
  return all_wrong;
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
  plan::Planner planner(scene, nullptr);
  support::Random random(5);
  const traj::Limits limits{{traj::Limit::speed, 8}, {traj::Limit::acceleration, 6}};
  std::size_t originals = 0;
  std::size_t missed = 0;
  while (originals < 1000) {
    const geom::Aabb& b = *scene.free_bounds();
    const Vec3 from = in_bounds(random, b, 40);
    const Vec3 to =
        from + Vec3(random.uniform(-60, 60), random.uniform(-60, 60), random.uniform(-5, 5));
    const plan::PlanResult path = planner.plan(from, to, {});
    if (path.status != geom::PathStatus::found) continue;
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
  std::size_t wrong = 0;
  for (const double offset : {0.0, 1e5, 5e5}) {
    wrong += compare_segments(scene.map(), offset, n / 3 + 1);
  }
  for (const double spacing : {25.0, 10.0}) {
    for (const auto connectivity : {plan::Connectivity::six, plan::Connectivity::twenty_six}) {
      wrong += compare_lattice(scene, exact, spacing, connectivity);
    }
  }
  wrong += move_into_touch(scene);
  return wrong != 0;
}
