#include "dji_file.h"

#include <fmt/format.h>

#include "traj/drone_file/dji_wpml.h"

namespace cli {
namespace {

void add_notes(const traj::DjiMission& mission, const traj::DjiRules& rules,
               const traj::FlownDji& flown, std::vector<std::string>& notes) {
  notes.push_back(fmt::format(
      "the take-off is assumed at latitude {:.7f}, longitude {:.7f} ({}), the ground at z = {:.3f}",
      flown.home_place.latitude, flown.home_place.longitude,
      flown.home_is_said ? "the file's takeOffRefPoint" : "below the first waypoint",
      *flown.ends.takeoff_from));
  if (mission.finish == traj::DjiFinish::hover) {
    notes.emplace_back("the flight ends without landing: the aircraft hovers");
  }
  if (flown.returns_at) {
    notes.push_back(
        fmt::format("the return to home is flown {:g} m above the take-off: set the "
                    "aircraft to return at that height",
                    *flown.returns_at));
  }
  if (flown.returns) {
    notes.emplace_back(mission.finish == traj::DjiFinish::first_waypoint
                           ? "the way back to the first waypoint is left out: the file does not "
                             "say it"
                       : mission.return_height || rules.return_height
                           ? "the return to home is left out: so near home, some aircraft land "
                             "where they are"
                           : "the return to home is left out: its height is a setting of the "
                             "aircraft; give it with --return-height");
  }
  if (mission.without_link != "goContinue") {
    notes.push_back(
        fmt::format("what the aircraft does when it loses its controller ({}) is not "
                    "looked at",
                    mission.without_link));
  }
}

}  // namespace

traj::Flown flown_dji_file(std::istream& in, const std::string& source,
                           const DroneFileOptions& options, const geom::Frame& frame,
                           std::vector<std::string>& notes) {
  const traj::DjiMission mission = traj::read_dji_kmz(in, source);
  const traj::DjiRules rules{options.placement.ground, options.mission.return_height};
  traj::FlownDji read =
      traj::flown_dji(mission, options.placement.mission_frame(frame), rules, source);
  add_notes(mission, rules, read, notes);
  traj::Flown flown;
  flown.path = std::move(read.path);
  flown.hold = std::move(read.hold);
  flown.legs = std::move(read.legs);
  flown.sweeps = std::move(read.sweeps);
  flown.home = read.home;
  flown.idle_items = mission.actions;
  flown.ends = read.ends;
  flown.lands_below = read.lands_below;
  flown.speed = read.speed;
  flown.returns = read.returns;
  flown.path_stray = traj::kMissionStray;
  return flown;
}

}  // namespace cli
