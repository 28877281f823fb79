#pragma once

// Returns that real autopilots flew, beside what Skyway says of them.

#include <string>
#include <vector>

#include "flown_track.h"
#include "traj/home/return_proof.h"

namespace firmware {

// A mission that was ended by an order. The table has a header and these columns:
// track,mission,autopilot,action,seconds,settings,drag; files beside the table; settings as
// NAME=VALUE with spaces between.
struct FlownReturn {
  Flight flight;
  traj::ReturnAction action = traj::ReturnAction::rtl;
  double ordered = 0;  // s after arming
  traj::Autopilot autopilot;
};
std::vector<FlownReturn> read_returns(const std::string& table);

// What is claimed of it: the stages of its mission, and the model of its return.
struct ReturnClaim {
  Replay replay;
  std::vector<traj::FlightStage> stages;
  traj::ReturnTask task;
  Vec3 ordered_at = Vec3::Zero();
};
ReturnClaim claim_of(const FlownReturn& flown);

// The parts of the stages that hold the place of the order, as small as prove_return makes them.
std::vector<traj::FlightStage> stages_there(const ReturnClaim& claim);

// Ways of the return from these stages.
std::vector<traj::ReturnSweep> ways_of(const FlownReturn& flown, const ReturnClaim& claim,
                                       const std::vector<traj::FlightStage>& stages);

// The samples from the order on.
std::vector<Sample> samples_after(const FlownReturn& flown, const ReturnClaim& claim);

// How far a place is outside of all ways, widened by what the model may be off; m along the worst
// axis, 0 inside, at most `most`. And the phase of the way that is nearest.
struct Exit {
  double outside = 0;
  traj::ReturnPhase phase = traj::ReturnPhase::braking;
};
Exit exit_of(const ReturnClaim& claim, const std::vector<traj::ReturnSweep>& ways,
             const Vec3& place, double most = 30);

}  // namespace firmware
