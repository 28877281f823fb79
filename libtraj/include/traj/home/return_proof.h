#pragma once

// Whether a vehicle comes home by itself from every instant of a flight.
//
// Example:
//   traj::ReturnTask task;
//   task.models = {traj::return_model(traj::px4("1.17"))};
//   task.home = geom::Vec3{0, 0, 0};
//   const std::vector<std::vector<traj::FlightStage>> stages{traj::stages_of(trajectory)};
//   const traj::ReturnReport proof = traj::prove_return(scene, stages, task);
//   std::cout << 100 * proof.share() << " % of the time\n";
//   for (const traj::ReturnGap& gap : proof.gaps) std::cout << "none from " << gap.from << " s\n";

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "geom/collision/collision.h"
#include "traj/home/return_sweeps.h"
#include "traj/record/return_report.h"

namespace traj {

struct ReturnTask {
  ReturnAction action = ReturnAction::rtl;
  std::vector<ReturnModel> models;  // any of which may fly; one list of stages each
  Vec3 home = Vec3::Zero();         // the ground there
  std::vector<Vec3> rally;          // places in the air
  std::vector<Fence> fences;        // that returns keep to
  std::vector<Vec3> pads;           // level ground on which the flight begins or ends
  Vec3 room = Vec3::Zero();  // m along each axis beside the vehicle, without its margin: how wrong
                             // it may be about its place
  double finest = 0.5;       // m: shorter stages are not divided
  // s after the epoch of the map at which the flight begins: boxes with times that are over by then
  // are not in the way. Nothing: each of them counts as always there.
  std::optional<double> start = {};
};

// From every stage of every model: its sweeps (return_sweeps) are clear of the map for the vehicle
// with the larger of its margin and the model's `around` with `room`, and keep to bounds and
// fences; a stage that is not clear is divided until its parts are, or are `finest` metres long.
// Sound: all places outside of the gaps' times have a return that is clear. Nothing is sampled. The
// same for any number of threads. `least_height` is left open. `stages` has one list for each of
// the models.
ReturnReport prove_return(const geom::CollisionScene& scene,
                          std::span<const std::vector<FlightStage>> stages, const ReturnTask& task);

// Metres along each axis from the vehicle's reference point that stay clear of obstacles while that
// model returns: its half sizes with the larger of its margin and what it may be off its way.
Vec3 return_half(const geom::CollisionScene& scene, const ReturnModel& model,
                 const ReturnTask& task);

// A part of a flight, the regions of the returns that begin anywhere in it, which are all clear,
// and the seconds that these may take.
struct ProvedStage {
  std::size_t model = 0;  // an index into those of the task
  FlightStage stage;
  std::vector<ReturnSweep> sweeps;
  double lasts = 0;
};

// The parts of a flight from which returns are proved: all of it if there are no gaps.
std::vector<ProvedStage> proved_stages(const geom::CollisionScene& scene,
                                       std::span<const std::vector<FlightStage>> stages,
                                       const ReturnTask& task);

// A region of a return that is proved, and the metres along each axis beside it for which it is,
// the scene's half sizes left out.
struct ProvedReturn {
  ReturnSweep sweep;
  FlightPart part;
  Vec3 beside = Vec3::Zero();
};

// The regions of all returns that prove_return() proves, from every stage.
std::vector<ProvedReturn> proved_returns(const geom::CollisionScene& scene,
                                         std::span<const std::vector<FlightStage>> stages,
                                         const ReturnTask& task);

// A return height, m above home, and the share of the time from which returns at it are proved.
struct ReturnHeight {
  double height = 0;
  double share = 0;
};

// The least return height (to `step` metres) at which returns are proved for as much of the time as
// at the greatest height that the map's bounds allow; nothing if they allow none. By bisection;
// what is returned was proved.
std::optional<ReturnHeight> best_return_height(const geom::CollisionScene& scene,
                                               std::span<const std::vector<FlightStage>> stages,
                                               ReturnTask task, double step = 0.5);

}  // namespace traj
