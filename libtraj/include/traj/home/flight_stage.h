#pragma once

// Stages of a flight: where the vehicle may be, and how it may move there.
//
// Example:
//   const std::vector<traj::FlightStage> stages = traj::stages_of(trajectory);
//   assert(stages.front().from == 0 && stages.back().until == traj::duration(trajectory));
//   const auto [early, late] = *traj::halves(stages.front());
//   assert(early.until <= late.until);

#include <optional>
#include <utility>
#include <vector>

#include "traj/curve/trajectory.h"
#include "traj/mission/flown/flown.h"
#include "traj/mission/flown/sweep.h"
#include "traj/record/return_report.h"

namespace traj {

// At any instant of the closed time from `from` to `until` that belongs to this stage, the
// reference point is in the convex hull of `where`, and its velocity in the convex hull of
// `velocity` and 0. A flight at an instant is in one of the stages that hold the instant.
struct FlightStage {
  double from = 0;  // s after the flight begins
  double until = 0;
  std::vector<Vec3> where;         // m; at least one point
  std::vector<Velocity> velocity;  // may be empty: it rests
  FlightPart part = {};
  std::optional<double> stands_on = {};  // as Sweep::stands_on

  // What the stage is a part of: a curve, or the legs whose times it has.
  std::optional<Segment> curve = {};
  std::vector<TimedLeg> legs = {};
};

// The two parts of a stage, the earlier first; together they hold all of it. Nothing for a stage
// that cannot be divided: one place, or an instant.
std::optional<std::pair<FlightStage, FlightStage>> halves(const FlightStage& stage);

// The first and the last places of a stage, each as a stage; nothing for one that cannot be
// divided.
std::optional<std::pair<FlightStage, FlightStage>> ends_of(const FlightStage& stage);

// How long the stage is: metres from end to end of `where`.
double extent(const FlightStage& stage);

// Of a trajectory: one for each segment, times exact.
std::vector<FlightStage> stages_of(const Trajectory& trajectory);

// Where an autopilot may be while it flies a mission, ways back to home left out. Times are
// estimates: a leg at its speed, and the holds.
std::vector<FlightStage> stages_of(const Drift& drift);

// Of legs and their regions, at `speed` m/s, and `climb` and `descent` where they say them.
// Regions that no leg leads through may be flown in any direction.
std::vector<FlightStage> stages_of(const FlownMission& mission, double speed);

// The ends of the same legs, each with the time that stages give it. Ways back to home are left
// out.
std::vector<TimedPlace> timeline_of(const Drift& drift);
std::vector<TimedPlace> timeline_of(const FlownMission& mission, double speed);

}  // namespace traj
