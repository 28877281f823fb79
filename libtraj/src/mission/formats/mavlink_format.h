#pragma once

// What the formats of MAVLink missions share.

#include "traj/mission/formats/mission_format.h"
#include "traj/mission/mavlink/mission.h"

namespace traj {

// What may be said beside them.
inline constexpr FileOptionSet kMavlinkReading{
    FileOption::origin,        FileOption::geoid,      FileOption::ground,
    FileOption::return_height, FileOption::terrain,    FileOption::acceptance,
    FileOption::braking,       FileOption::autopilot,  FileOption::params,
    FileOption::drag,          FileOption::navigation, FileOption::ground_model,
    FileOption::terrain_error, FileOption::geoid_grid};
inline constexpr FileOptionSet kMavlinkWriting{
    FileOption::tolerance,  FileOption::speed,         FileOption::hover,
    FileOption::ground,     FileOption::origin,        FileOption::geoid,
    FileOption::autopilot,  FileOption::params,        FileOption::drag,
    FileOption::navigation, FileOption::return_height, FileOption::rally,
    FileOption::fence,      FileOption::fence_budget,  FileOption::params_out,
    FileOption::procedure,  FileOption::geoid_grid};

inline constexpr double kMissionRounding = 0.03;  // m: MissionFormat::rounding

ReadFlights fly_mission(const Mission& mission, const ReadTask& task);

// `write` gives the texts of the mission.
WrittenMission write_mission(const MissionTask& task, const geom::Polyline& legs,
                             WrittenMission (*write)(const Mission& mission,
                                                     const MissionTask& task));

// At first no waypoint is a rest, but where the path has so many that trying each would take long.
void pass_all(MissionTask& task, const geom::Polyline& legs);

// A waypoint that is passed becomes a rest; before a stop that is overshot too far, the vehicle
// slows down.
bool rest_or_slow_down(const WrittenMission& written, const CheckResult& result, MissionTask& task);

// The row of a format of MAVLink missions, with all that they share. `further`: what else may be
// said beside one that is written.
constexpr MissionFormat mavlink_format(const geom::Format& format,
                                       decltype(MissionFormat::may_be) may_be,
                                       decltype(MissionFormat::read) read,
                                       decltype(MissionFormat::write) write,
                                       FileOptionSet further = {}) {
  return {.format = format,
          .may_be = may_be,
          .read = read,
          .write = write,
          .prepare = pass_all,
          .mend = rest_or_slow_down,
          .reads_with = kMavlinkReading,
          .writes_with = kMavlinkWriting.with(further),
          .has_legs = true,
          .rounding = kMissionRounding,
          .heights = FileHeights::above_home};
}

}  // namespace traj
