#include "traj/solve.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "traj/bernstein.h"
#include "traj/check.h"
#include "traj/corridor.h"
#include "traj/min_snap.h"
#include "traj/nominal.h"
#include "traj/optimize.h"
#include "traj/stop_and_go.h"
#include "traj/time_allocation.h"
#include "traj/time_scaling.h"

namespace traj {
namespace {

// How much slower than the trapezoid along the path a proved closed form may be before the
// optimiser is worth its time.
constexpr double kNearlyAsFast = 1.1;
constexpr double kReach = 10;  // metres: obstacles further off get a plane only when met
constexpr int kRounds = 5;

Trajectory closed_form(const geom::Polyline& path, const Limits& limits) {
  const auto times = stopping_times(path, nominal_profile(limits, geom::length(path)));
  const Trajectory curve = min_snap(path, times);
  return slowed(curve, smallest_factor(curve, limits));
}

// About the least time along the path, corners left out: a trapezoid of the mean of the speeds
// allowed along its legs.
double fastest(const geom::Polyline& path, const Limits& limits) {
  const double length = geom::length(path);
  if (length == 0) return 0;
  const double most = std::numeric_limits<double>::infinity();
  SpeedProfile profile = nominal_profile(limits, length);
  double time = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vec3 leg = path[i] - path[i - 1];
    time += std::max({leg.norm() / limits.vmax.value_or(most),
                      leg.head<2>().norm() / limits.vmax_h.value_or(most),
                      std::abs(leg.z()) / limits.vmax_v.value_or(most)});
  }
  if (time > 0) profile.vmax = length / time;
  return leg_time(length, 0, 0, profile);
}

std::string words(const CheckResult& verdict) {
  return verdict.reason + " at " + std::to_string(verdict.time) + " s";
}

// Notes the reason where the proof fails.
bool proved(const geom::CollisionScene& scene, const Trajectory& trajectory, const Limits& limits,
            SolveResult& result) {
  const CheckResult verdict = check(scene, trajectory, limits);
  if (!verdict.ok) result.reason = words(verdict);
  return verdict.ok;
}

void accept(const Trajectory& trajectory, const std::string& rung, SolveResult& result) {
  result.status = SolveStatus::solved;
  result.reason.clear();
  result.trajectory = trajectory;
  result.rung = rung;
  result.snap = snap_cost(trajectory);
}

// Optimises until the result is proved, adding planes for what it ran into. The start is the same
// each round: from the last result it would stay beside the obstacle it had just hit.
std::optional<Trajectory> optimised(const geom::CollisionScene& scene, const geom::Polyline& path,
                                    const SolveOptions& options, SolveResult& result) {
  Corridor corridor = pieces_between(joints(path));
  if (corridor.empty()) return std::nullopt;
  add_planes(scene, kReach, corridor);
  for (result.rounds = 1;; ++result.rounds) {
    const OptimizeResult round =
        optimize(corridor, {options.limits, options.rho, options.max_iterations});
    result.solver_status = round.status;
    result.iterations += round.iterations;
    result.objective = round.objective;
    result.max_violation = round.max_violation;
    const Trajectory curve =
        slowed(round.trajectory, smallest_factor(round.trajectory, options.limits));
    if (proved(scene, curve, options.limits, result)) return curve;
    if (result.rounds == kRounds || add_planes_met(scene, curve, corridor) == 0) {
      return std::nullopt;
    }
  }
}

// The first rung that is proved, from what is left.
void climb(const geom::CollisionScene& scene, const geom::Polyline& path,
           const SolveOptions& options, SolveResult& result) {
  const bool all = options.solver == Solver::automatic;
  std::optional<Trajectory> closed;
  if (all || options.solver == Solver::closed) {
    const Trajectory curve = closed_form(path, options.limits);
    if (proved(scene, curve, options.limits, result)) closed = curve;
    if (closed && (!all || duration(*closed) <= kNearlyAsFast * fastest(path, options.limits))) {
      return accept(*closed, "closed", result);
    }
  }
  if (all || options.solver == Solver::ipopt) {
    const auto curve = optimised(scene, path, options, result);
    if (curve) return accept(*curve, "ipopt", result);
  }
  if (all || options.solver == Solver::stop_and_go) {
    const Trajectory curve = stop_and_go(path, options.limits);
    if (closed && duration(*closed) <= duration(curve)) return accept(*closed, "closed", result);
    if (proved(scene, curve, options.limits, result)) accept(curve, "stop_and_go", result);
  }
}

}  // namespace

SolveResult solve(const geom::CollisionScene& scene, const geom::Polyline& path,
                  const SolveOptions& options) {
  SolveResult result;
  result.solver_status = "was not run";
  if (path.empty()) {
    result.reason = "the path has no point";
    return result;
  }
  climb(scene, path, options, result);
  return result;
}

}  // namespace traj
