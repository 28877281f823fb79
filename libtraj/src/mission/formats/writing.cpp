#include "traj/mission/formats/writing.h"

#include <algorithm>

#include "geom/import/volume_keep_out.h"
#include "traj/mission/formats/mission_format.h"

namespace traj {

bool knows_height(const MissionTask& task) {
  return task.options.placement.origin || geom::knows_height(task.frame);
}

std::optional<double> speed_limit(const Limits& limits) {
  std::optional<double> speed;
  for (const auto& limit :
       {limits[Limit::speed], limits[Limit::horizontal_speed], limits[Limit::vertical_speed]}) {
    if (limit) speed = std::min(speed.value_or(*limit), *limit);
  }
  return speed;
}

std::optional<double> speed_along_legs(const MissionTask& task) {
  Limits limits = task.limits;
  const auto climbs_at_most = task.format->climbs_at_most;
  const double climb = climbs_at_most ? climbs_at_most(task.options) : 0;
  std::optional<double>& vertical = limits[Limit::vertical_speed];
  if (climb > 0 && vertical && climb <= *vertical) vertical.reset();
  return speed_limit(limits);
}

std::string unchecked_note(const MissionTask& task) {
  return task.checked ? "" : "UNCHECKED: not compared with any map";
}

Placement placement_to_read(const MissionTask& task, const MissionFrame& over) {
  Placement placement = task.options.placement;
  placement.origin = over.origin;
  placement.ground.reset();
  return placement;
}

}  // namespace traj
