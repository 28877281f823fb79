// A program outside the project: plans, solves and proves with the installed libraries.

#include <geom/collision/collision.h>
#include <plan/planner/plan.h>
#include <traj/solve/solve.h>

int main() {
  geom::BoxTable table{{{{4, 0, 0}, {5, 8, 8}}}, {1}, {0}, {""}};
  geom::BoxMapSpec spec;
  spec.bounds = {{0, 0, 0}, {10, 10, 10}};
  const geom::CollisionScene scene(geom::BoxMap(spec, table), {"box", {0.5, 0.5, 0.5}}, 0);
  plan::Planner planner(scene, nullptr);
  const plan::PlanResult path = planner.plan({1, 1, 1}, {9, 1, 1}, {});
  traj::SolveOptions options;
  options.limits[geom::Limit::speed] = 2;
  options.limits[geom::Limit::acceleration] = 2;
  return traj::solve(scene, path.path, options).status == traj::SolveStatus::solved ? 0 : 1;
}
