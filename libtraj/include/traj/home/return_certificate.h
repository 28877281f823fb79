#pragma once

// Why a flight has a return from every instant, as text that others can follow.
//
// Example:
//   traj::ReturnTask task;
//   task.models = {traj::return_model(traj::px4("1.17"))};
//   const std::vector<std::vector<traj::FlightStage>> stages{traj::stages_of(trajectory)};
//   const auto proved = traj::proved_stages(scene, stages, task);
//   const std::string reasons = traj::return_reasons(scene, task, proved);
//   assert(reasons.starts_with("[{\"autopilot\":"));

#include <span>
#include <string>

#include "geom/collision/collision.h"
#include "traj/home/return_proof.h"

namespace traj {

// JSON, a list with an object for each model: what stays clear around the vehicle, and the parts of
// the flight with the regions of their returns (docs/certificates.md).
std::string return_reasons(const geom::CollisionScene& scene, const ReturnTask& task,
                           std::span<const ProvedStage> proved);

}  // namespace traj
