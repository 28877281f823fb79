#pragma once

// --tube of trajectories: the map must be clear with the tube of each around it.

#include <optional>
#include <string>

#include "cli/option/scenes.h"
#include "traj/record/report_record.h"
#include "traj/record/tube_reports.h"

namespace checking {

class Tubes {
 public:
  // Reads the file. `scenes` must outlive this; `margin` is kept around vehicle and tube.
  Tubes(const std::string& file, const cli::Scenes& scenes, double margin);

  // Of a solved trajectory over its scene. Throws geom::InputError where the file has no tube of
  // it. Threads may call at once.
  traj::TubeReport check(const geom::CollisionScene& scene,
                         const traj::TrajectoryRecord& record) const;

 private:
  std::optional<traj::VehicleProfile> profile_;
  double margin_;
  traj::TubeReports tubes_;
  mutable geom::Scenes scenes_;  // with that margin, whatever the records keep beside a tube
};

}  // namespace checking
