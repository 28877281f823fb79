#pragma once

// Whether a vehicle comes home by itself from every instant of a record or a drone file.
//
// Example:
//   traj::Flier flier;
//   flier.autopilots = {traj::px4("1.17")};
//   traj::TrajectoryRecord record{.id = "q1", .status = traj::TrajectoryStatus::solved};
//   record.trajectory = trajectory;
//   const auto returns = traj::check_return(scene, record, flier, {.height = 60});
//   std::cout << 100 * returns.share() << " % of the time\n";

#include <optional>

#include "geom/collision/collision.h"
#include "geom/record/record.h"
#include "traj/home/return_proof.h"
#include "traj/mission/read_mission.h"
#include "traj/record/return_report.h"
#include "traj/record/trajectory_record.h"

namespace traj {

struct ReturnRules {
  ReturnAction action = ReturnAction::rtl;
  std::optional<double> height = {};  // m above home; else that of each autopilot
  std::optional<Vec3> home = {};      // the ground there; else a mission's own, or below its begin
  std::optional<double> speed = {};   // m/s of paths, which have none
  std::optional<double> start = {};   // as ReturnTask::start
  bool least_height = true;           // look for it too
  bool reasons = false;               // say why there are no gaps, for a certificate
};

// From every instant of a trajectory, or of a path that is flown at `rules.speed`; `flier` says
// which autopilots may fly, and how wrong they may be about their place. Throws UsageError for a
// path without a speed.
ReturnReport check_return(const geom::CollisionScene& scene, const TrajectoryRecord& record,
                          const Flier& flier, const ReturnRules& rules);
ReturnReport check_return(const geom::CollisionScene& scene, const geom::PathRecord& record,
                          const Flier& flier, const ReturnRules& rules);

// From wherever each autopilot may be while it flies a mission, or an aircraft of DJI, with the
// mission's rally points and fences. Throws UsageError for files that no autopilot flies, without a
// home, and without a speed or a return height where nobody says them.
ReturnReport check_return(const geom::CollisionScene& scene, const FileFlight& file,
                          const Flier& flier, const ReturnRules& rules);

}  // namespace traj
