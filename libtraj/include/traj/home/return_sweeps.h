#pragma once

// Where a vehicle may be from the instant when it leaves a flight until it stands on the ground.
//
// Example:
//   const traj::ReturnModel model = traj::return_model(traj::px4("1.17"));
//   const traj::ReturnPlace home{{0, 0, 0}};
//   const auto stage = traj::stages_of(trajectory).front();
//   for (const traj::ReturnSweep& one : traj::return_sweeps(model, stage, home)) {
//     std::cout << traj::name(one.phase) << ": " << one.sweep.hull.size() << " points\n";
//   }

#include <string_view>
#include <vector>

#include "geom/text/words.h"
#include "traj/home/flight_stage.h"
#include "traj/home/return_model.h"

namespace traj {

enum class ReturnPhase { braking, climb, way, descent, landing };
inline constexpr geom::Words<ReturnPhase, 5> kReturnPhaseWords{{
    {ReturnPhase::braking, "braking"},
    {ReturnPhase::climb, "climb"},
    {ReturnPhase::way, "way"},
    {ReturnPhase::descent, "descent"},
    {ReturnPhase::landing, "landing"},
}};
constexpr std::string_view name(ReturnPhase phase) {
  return geom::word_of(kReturnPhaseWords, phase);
}

struct ReturnSweep {
  Sweep sweep;
  ReturnPhase phase = ReturnPhase::braking;
};

// Where a return ends: the ground there, and for a rally point the height that the file gives it.
struct ReturnPlace {
  Vec3 ground = Vec3::Zero();  // m
  double above_ground = 0;     // m: a rally point's own height
  bool is_rally = false;
};

// Where it comes to rest after it left a stage: all places between, as one hull.
std::vector<Vec3> braking_hull(const ReturnModel& model, const FlightStage& stage);

// All ways of a return that begins anywhere in the stage: braking, up, across, down to the ground.
std::vector<ReturnSweep> return_sweeps(const ReturnModel& model, const FlightStage& stage,
                                       const ReturnPlace& place);

// Brakes, and lands on what is below: down to `floor`; tops that are no higher than `ground` are
// stood on.
std::vector<ReturnSweep> landing_sweeps(const ReturnModel& model, const FlightStage& stage,
                                        double ground, double floor);

}  // namespace traj
