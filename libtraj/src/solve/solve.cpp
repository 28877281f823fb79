#include "traj/solve/solve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "curve/bernstein.h"
#include "geom/map/wider_bounds.h"
#include "solve/nominal.h"
#include "solve/optimize.h"
#include "solve/stop_and_go.h"
#include "solve/time_allocation.h"
#include "solve/time_scaling.h"
#include "traj/proof/check.h"
#include "traj/solve/closed_form.h"
#include "traj/solve/corridor.h"
#include "traj/solve/min_snap.h"

namespace traj {
namespace {

// How much slower than the trapezoid along the path a proved closed form may be before the
// optimiser is worth its time.
constexpr double kNearlyAsFast = 1.1;
constexpr double kReach = 10;   // metres: obstacles further off get a plane only when met
constexpr double kShort = 0.1;  // metres: shorter legs are left to the optimiser only where needed
constexpr double kLeg = 0.5;    // metres: shorter ones are left out where a cruise did not settle
constexpr double kUsual = 20;   // metres: on shorter paths in proportion
constexpr int kRounds = 5;
constexpr double kNoEnd = std::numeric_limits<double>::infinity();
constexpr const char* kNotRun = "was not run";

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
    time += std::max({leg.norm() / limits[Limit::speed].value_or(most),
                      leg.head<2>().norm() / limits[Limit::horizontal_speed].value_or(most),
                      std::abs(leg.z()) / limits[Limit::vertical_speed].value_or(most)});
  }
  if (time > 0) profile.vmax = length / time;
  return leg_time(length, 0, 0, profile);
}

std::string words(const CheckResult& verdict) {
  return std::string(name(verdict.reason)) + " at " + std::to_string(verdict.time) + " s";
}

// Counts the proof, and notes the reason where it fails.
bool proved(const geom::CollisionScene& scene, const Trajectory& trajectory, const Limits& limits,
            SolveResult& result) {
  ++result.proofs;
  CheckOptions options;
  options.limits = limits;
  options.clearance = Clearance::left_out;
  const CheckResult verdict = check(scene, trajectory, options);
  if (!verdict.ok) result.reason = words(verdict);
  return verdict.ok;
}

void accept(const Trajectory& trajectory, Rung rung, SolveResult& result) {
  result.status = SolveStatus::solved;
  result.reason.clear();
  result.trajectory = trajectory;
  result.rung = rung;
  result.snap = snap_cost(trajectory);
}

Corridor corridor_along(CorridorKind kind, const geom::CollisionScene& scene,
                        const geom::Polyline& path) {
  if (kind == CorridorKind::boxes) return box_corridor(scene, path, kReach);
  Corridor corridor = pieces_between(joints(path));
  add_planes(scene, kReach, corridor);
  return corridor;
}

// A path as the optimiser gets it, and what to do where a part beside a cruise does not settle.
class Way {
 public:
  Way(CorridorKind kind, const geom::CollisionScene& scene, const geom::Polyline& given)
      : kind_(kind),
        scene_(scene),
        share_(std::min(1.0, geom::length(given) / kUsual)),
        path_(without_short_legs(scene, given, kShort * share_)) {}

  Corridor corridor() const { return corridor_along(kind_, scene_, path_); }

  // Along the path without legs of decimetres, at which the optimiser makes ever smaller steps.
  // Empty where there are none.
  Corridor of_longer_legs() const {
    const geom::Polyline path = without_short_legs(scene_, path_, kLeg * share_);
    return path == path_ ? Corridor() : corridor_along(kind_, scene_, path);
  }

  const geom::CollisionScene& scene() const { return scene_; }

 private:
  CorridorKind kind_;
  const geom::CollisionScene& scene_;
  double share_;  // of lengths that are usual in a city
  geom::Polyline path_;
};

// Optimises until the result is proved, adding planes for what it ran into. The start is the same
// each round: from the last result it would stay beside the obstacle it had just hit. Where Ipopt
// may follow, the other optimiser gives up as soon as it does not settle.
std::optional<Trajectory> optimised_in(const Way& way, Optimizer optimizer,
                                       const SolveOptions& options, SolveResult& result) {
  Corridor corridor = way.corridor();
  if (corridor.empty()) return std::nullopt;
  const int most = result.rounds + kRounds;
  std::optional<Corridor> first;  // where its cruises did not settle, once others were tried
  // What cruises stays on the path and hands on its speed: where that is not proved, or a part
  // beside it does not settle, the optimiser takes all of it, which takes many times as long.
  for (bool cruise = true;;) {
    ++result.rounds;
    result.corridor = corridor;
    const OptimizeResult round = optimize(
        corridor, {options.limits, options.rho, options.max_iterations, optimizer, cruise});
    result.solver_status = round.status;
    result.iterations += round.iterations;
    result.objective = round.objective;
    result.max_violation = round.max_violation;
    if (round.cruises && !round.settled) {
      Corridor longer = first ? Corridor() : way.of_longer_legs();
      cruise = !longer.empty();
      if (cruise) first = std::exchange(corridor, std::move(longer));
      if (!cruise && first) corridor = *first;
      continue;
    }
    const bool ipopt_follows =
        options.solver == Solver::automatic && optimizer == Optimizer::banded;
    if (ipopt_follows && !round.settled) return std::nullopt;
    const Trajectory curve =
        slowed(round.trajectory, smallest_factor(round.trajectory, options.limits));
    if (proved(way.scene(), curve, options.limits, result)) return curve;
    if (result.rounds == most) return std::nullopt;
    if (add_planes_met(way.scene(), curve, corridor) == 0 && !round.cruises) return std::nullopt;
    cruise = false;
  }
}

std::vector<Optimizer> optimizers(Solver solver) {
  switch (solver) {
    case Solver::automatic:
      return {Optimizer::banded, Optimizer::ipopt};
    case Solver::banded:
      return {Optimizer::banded};
    case Solver::ipopt:
      return {Optimizer::ipopt};
    default:
      return {};
  }
}

// In the corridor asked for, else in one of the other kind, which may leave more room: each
// optimiser tries both, for the first takes a tenth of the time that the second does. Cut off by
// the iterations, a result may be proved and yet take longer than `most` seconds.
bool optimised(const geom::CollisionScene& scene, const geom::Polyline& path,
               const SolveOptions& options, double most, SolveResult& result) {
  const bool boxes = options.corridor == CorridorKind::boxes;
  const auto other = boxes ? CorridorKind::planes : CorridorKind::boxes;
  for (const Optimizer optimizer : optimizers(options.solver)) {
    for (const CorridorKind kind : {options.corridor, other}) {
      const auto curve = optimised_in(Way(kind, scene, path), optimizer, options, result);
      if (!curve || duration(*curve) > most) continue;
      accept(*curve, optimizer == Optimizer::banded ? Rung::banded : Rung::ipopt, result);
      return true;
    }
  }
  return false;
}

// The first rung that is proved, from what is left. The waypoints hold nowhere.
void climb(const geom::CollisionScene& scene, std::span<const Waypoint> waypoints,
           const SolveOptions& options, SolveResult& result) {
  geom::Polyline path;
  bool given = false;
  for (const Waypoint& w : waypoints) {
    path.push_back(w.position);
    given = given || w.velocity;
  }
  const bool all = options.solver == Solver::automatic;
  std::optional<Trajectory> closed;  // not known to fail; proved only where it would be taken
  if (all || options.solver == Solver::closed) {
    closed = closed_form(scene, waypoints, options.limits, options.times.value_or(Times::stops));
    if (!closed) result.reason = "no leg times hold the limits at the velocities given";
    const bool asked = !all || options.times || given;
    const double most = asked ? kNoEnd : kNearlyAsFast * fastest(path, options.limits);
    if (closed && duration(*closed) <= most) {
      if (proved(scene, *closed, options.limits, result))
        return accept(*closed, Rung::closed, result);
      closed.reset();
    }
  }
  if (given) {
    if (result.reason.empty()) result.reason = "only the closed form keeps given velocities";
    return;
  }
  const double most = all ? duration(stop_and_go(path, options.limits)) : kNoEnd;
  if (optimised(scene, path, options, most, result)) return;
  if (all || options.solver == Solver::stop_and_go) {
    const Trajectory curve = stop_and_go(path, options.limits);
    if (closed && duration(*closed) <= duration(curve) &&
        proved(scene, *closed, options.limits, result)) {
      return accept(*closed, Rung::closed, result);
    }
    if (proved(scene, curve, options.limits, result)) accept(curve, Rung::stop_and_go, result);
  }
}

// Flies `part` after what `whole` has already.
void append(const SolveResult& part, SolveResult& whole) {
  if (part.solver_status != kNotRun) whole.solver_status = part.solver_status;
  whole.iterations += part.iterations;
  whole.rounds += part.rounds;
  whole.proofs += part.proofs;
  whole.objective = std::max(whole.objective, part.objective);
  whole.max_violation = std::max(whole.max_violation, part.max_violation);
  whole.rung = std::max(whole.rung, part.rung);  // none is the least
  whole.corridor.insert(whole.corridor.end(), part.corridor.begin(), part.corridor.end());
  auto& segments = whole.trajectory.segments;
  segments.insert(segments.end(), part.trajectory.segments.begin(), part.trajectory.segments.end());
}

SolveResult solve_part(const geom::CollisionScene& scene, std::span<const Waypoint> part,
                       const SolveOptions& options) {
  SolveResult result;
  result.solver_status = kNotRun;
  climb(scene, part, options, result);
  return result;
}

SolveResult solve_with_holds(const geom::CollisionScene& scene, std::vector<Waypoint> waypoints,
                             const SolveOptions& options) {
  SolveResult whole;
  whole.solver_status = kNotRun;
  std::size_t first = 0;
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    const double hold = std::exchange(waypoints[i].hold, 0);
    if (hold == 0 && i + 1 < waypoints.size()) continue;
    if (i > first) {
      const SolveResult part =
          solve_part(scene, std::span(waypoints).subspan(first, i + 1 - first), options);
      if (part.status != SolveStatus::solved) return part;
      append(part, whole);
    }
    if (hold > 0) {
      const State here{waypoints[i].position};
      whole.trajectory.segments.push_back(hermite(here, here, hold));
    }
    first = i;
  }
  if (!whole.rung) whole.rung = Rung::closed;
  if (proved(scene, whole.trajectory, options.limits, whole)) {
    accept(Trajectory(whole.trajectory), *whole.rung, whole);
  } else {
    whole.trajectory = {};
    whole.rung.reset();
  }
  return whole;
}

// Why a path leaves the bounds, or nothing: no solver could bring it back.
std::string leaves_bounds(const geom::CollisionScene& scene, std::span<const Waypoint> places) {
  geom::WiderBounds wider(scene.map().spec().bounds);
  for (const Waypoint& w : places) {
    if (scene.inside_bounds(w.position) || !w.position.allFinite()) continue;
    wider.add({w.position - scene.half(), w.position + scene.half()});
  }
  if (!wider.any()) return "";
  return fmt::format("the path leaves the bounds: {}; {}", wider.in_words(), wider.advice());
}

}  // namespace

SolveResult solve(const geom::CollisionScene& scene, std::span<const Waypoint> waypoints,
                  const SolveOptions& options) {
  SolveResult result;
  result.solver_status = kNotRun;
  if (waypoints.empty()) {
    result.reason = "the path has no point";
    return result;
  }
  const std::vector<double> no_time(waypoints.size() - 1, 0.0);
  const std::vector<Waypoint> places = without_repeats(waypoints, no_time).waypoints;
  result.reason = leaves_bounds(scene, places);
  if (!result.reason.empty()) return result;
  const auto holds = [](const Waypoint& w) { return w.hold > 0; };
  if (std::any_of(places.begin(), places.end(), holds)) {
    return solve_with_holds(scene, places, options);
  }
  return solve_part(scene, places, options);
}

SolveResult solve(const geom::CollisionScene& scene, const geom::Polyline& path,
                  const SolveOptions& options) {
  return solve(scene, waypoints_at(path), options);
}

}  // namespace traj
