#pragma once

// The proof: whether a whole trajectory is free of collision and inside its limits.
//
// Example:
//   const traj::CheckResult result = traj::check(scene, trajectory, limits);
//   assert(result.ok);
//   std::cout << result.clearance->value << " m clear at " << result.clearance->time << " s\n";
//   const traj::CheckResult through = traj::check_path(scene, {{{1, 1, 1}, {9, 1, 1}}});
//   assert(through.reason == traj::Reason::collision);

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geom/collision/collision.h"
#include "traj/curve/trajectory.h"
#include "traj/proof/flight_part.h"
#include "traj/proof/limits.h"
#include "traj/proof/reason.h"

namespace traj {

// How far the flight may be from a segment at any instant, because the vehicle's own arithmetic
// rounds.
struct Stray {
  Vec3 position = Vec3::Zero();  // m along each axis
  double velocity = 0;           // m/s, m/s2, m/s3: of the norms
  double acceleration = 0;
  double jerk = 0;
  double yaw_rate = 0;  // rad/s
};

// Whether a check measures the clearance too. It changes no verdict, and costs more than one.
enum class Clearance { measured, left_out };

inline constexpr double kStepShare = 1e-3;

struct CheckOptions {
  Limits limits;
  // One for each segment, or empty. All curves that are so near to the segment must be clear and
  // within the limits. Must outlive the check.
  std::span<const Stray> stray;
  // How far neighbouring segments may miss each other at a joint. The straight step between
  // them is tested for collision as well.
  double position_gap = 1e-9;      // metres
  double velocity_gap = 1e-6;      // m/s
  double acceleration_gap = 1e-4;  // m/s2
  double yaw_gap = 1e-9;           // radians
  double yaw_rate_gap = 1e-6;      // rad/s
  // Steps add up. So a step is at most this share of what a limit on the next derivative allows in
  // the time of the shorter segment, and the flight keeps the limits but for twice this
  // share.
  double step_share = kStepShare;
  double limit_slack = 0;  // relative, on every limit
  Clearance clearance = Clearance::measured;
  // When it begins, seconds after the epoch of the scene's map, within geom::kLargestTime: boxes
  // that are there for a time must be clear at that time only (closed at both ends, rounded
  // outward). Nothing: each of them counts as always there.
  std::optional<double> start;
  // Whether the vehicle stands at its first point before, and at its last point after, for ever,
  // and must be clear of boxes that are there then. Matters only with `start`.
  bool stands = false;
};

struct Extreme {
  double value = 0;
  double time = 0;  // seconds from the start of the trajectory
};

struct CheckResult {
  bool ok = false;
  bool looked = false;  // at the place; else only the reason is known
  // The first that holds, in the order of Reason, limits in that of kOrderOfLimits. Outside of
  // domain.h nothing is measured.
  Reason reason = Reason::none;
  double time = 0;                 // of the worst violation, seconds
  Vec3 place = Vec3::Zero();       // where that is, metres
  std::optional<std::size_t> box;  // the obstacle hit: an index into BoxMap::boxes()
  double worst = 0;  // how bad: penetration or way out of bounds or gap in metres, else the value
  std::optional<FlightPart> part;  // of a mission: where that is
  // If a mission is refused because an autopilot may stray from its way: that autopilot.
  std::string strayed = {};

  std::size_t looked_at = 0;  // obstacles near the pieces of the curve: the cost of the place

  double duration = 0;  // seconds
  // Metres to the obstacles that are there at the instant, grown by the vehicle without its margin,
  // the least: of trajectories to 1 mm, of paths to rounding. Absent without obstacles, and where
  // it was left out.
  std::optional<Extreme> clearance;
  // The largest measured values, to a relative 1e-4. Absent: not measured, as for a path, which
  // has no times, and for the yaw rate of a trajectory without yaw.
  PerLimit<std::optional<Extreme>> largest;
  std::optional<std::array<double, 7>> jumps;  // at joints, see continuity.h
};

// Decides by control points: a piece whose control points' box meets no grown obstacle is clear
// (the curve lies in their convex hull), others are halved. Sound in floating point: rounding is
// added to every box, so "ok" holds in real arithmetic, and what is refused comes within 1e-9 m of
// an obstacle or 1e-12 (relative) of a limit; of a box that is there for a time, at an instant
// within 1e-6 s of that time (1e-12 of the duration, where that is more). A segment whose control
// points all equal one end or the other is the straight line between, and is decided exactly.
CheckResult check(const geom::CollisionScene& scene, const Trajectory& trajectory,
                  const CheckOptions& options);
CheckResult check(const geom::CollisionScene& scene, const Trajectory& trajectory,
                  const Limits& limits);

// The same for a path: bounds and collision of every leg, exact, or of all that is within its
// `stray`, metres along each axis, one a leg (empty: none). `time` is then the index of the leg.
CheckResult check_path(const geom::CollisionScene& scene, std::span<const Vec3> points,
                       std::span<const Vec3> stray = {}, Clearance clearance = Clearance::measured);

// The limits that were asked for and are not measured in a result, in the order of kOrderOfLimits.
std::vector<Limit> not_measured(const CheckResult& result, const Limits& limits);

}  // namespace traj
