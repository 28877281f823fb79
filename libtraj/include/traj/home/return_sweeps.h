#pragma once

// Where a vehicle may be from the instant when it leaves a flight until it stands on the ground.
//
// Example:
//   const traj::ReturnModel model = traj::return_model(traj::px4("1.17"));
//   const traj::ReturnPlace home{{0, 0, 0}};
//   const auto stage = traj::stages_of(trajectory).front();
//   for (const traj::ReturnSweep& one : traj::return_sweeps(model, stage, home)) {
//     std::cout << traj::name(one.phase) << " up to " << one.region.high << " m\n";
//   }

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "geom/text/words.h"
#include "traj/home/flight_stage.h"
#include "traj/home/prism.h"
#include "traj/home/return_model.h"
#include "traj/home/return_places.h"

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
  Prism region;
  ReturnPhase phase = ReturnPhase::braking;
  std::optional<double> stands_on = {};  // as Sweep::stands_on
};

// As a region of a flight.
Sweep sweep_of(const ReturnSweep& one, const FlightPart& part);

// Where it may be from the instant when it leaves the stage until it rests: in plan the way to rest
// of each velocity from each place, and as much behind as a stop is overshot; in height what it
// still rises or sinks.
Prism braking_region(const ReturnModel& model, const FlightStage& stage);

// All ways of a return that begins anywhere in the stage: braking, up, across, down to the ground.
// Within the cone it goes across no lower than the cone is where the stage is nearest to the place.
// Sources: PX4's rtl.cpp and rtl_direct.cpp, ArduPilot Copter's mode_rtl.cpp.
std::vector<ReturnSweep> return_sweeps(const ReturnModel& model, const FlightStage& stage,
                                       const ReturnPlace& place);

// Brakes, and stays.
std::vector<ReturnSweep> holding_sweeps(const ReturnModel& model, const FlightStage& stage);

// Brakes, and lands on what is below: down to `floor`. Tops no higher than `ground` are stood on.
std::vector<ReturnSweep> landing_sweeps(const ReturnModel& model, const FlightStage& stage,
                                        double ground, double floor);

// Seconds that these ways may take, by the model's speeds, twice and a minute: an estimate.
double longest_seconds(const ReturnModel& model, std::span<const ReturnSweep> sweeps);

}  // namespace traj
