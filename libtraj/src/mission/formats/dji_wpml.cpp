#include "traj/mission/dji/dji_wpml.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "geom/base/text_stream.h"
#include "geom/map/frame.h"
#include "geom/text/beginning.h"
#include "mission/formats/mavlink_format.h"
#include "mission/formats/text_head.h"
#include "traj/mission/dji/dji_flight.h"
#include "traj/mission/formats/mission_formats.h"

namespace traj {
namespace {

// What nobody but its operator says of heights above the surface.
std::string surface_note(const DjiMission& mission, const TerrainClaim& terrain) {
  const auto [low, high] = *terrain.surface;
  std::string out = fmt::format(
      "the aircraft follows the surface as it sees it, roofs and trees included: what was looked "
      "at "
      "is a band of up to {:.1f} m, for an aircraft that stays {:g} to {:g} m above the ground of "
      "the height model",
      terrain.band, low, high);
  for (const DjiWayline& wayline : mission.waylines) {
    for (const DjiWaypoint& one : wayline.waypoints) {
      if (one.height < low || one.height > high) {
        return out + fmt::format("; its file names {:g} m (executeHeight), which is not there",
                                 one.height);
      }
    }
  }
  return out;
}

std::vector<std::string> notes_of(const DjiMission& mission, const DjiRules& rules,
                                  const FlownDji& flown) {
  std::vector<std::string> notes;
  notes.push_back(fmt::format(
      "the take-off is assumed at latitude {:.7f}, longitude {:.7f} ({}), the ground at z = {:.3f}",
      flown.home_place.latitude, flown.home_place.longitude,
      flown.home_is_said ? "the file's takeOffRefPoint" : "below the first waypoint",
      *flown.ends.takeoff_from));
  if (flown.terrain) notes.push_back(surface_note(mission, *flown.terrain));
  if (mission.finish == DjiFinish::hover) {
    notes.emplace_back("the flight ends without landing: the aircraft hovers");
  }
  if (flown.returns_at) {
    notes.push_back(
        fmt::format("the return to home is flown {:g} m above the take-off: set the "
                    "aircraft to return at that height",
                    *flown.returns_at));
  }
  if (flown.returns) {
    notes.emplace_back(mission.finish == DjiFinish::first_waypoint
                           ? "the way back to the first waypoint is left out: the file does not "
                             "say it"
                       : mission.return_height || rules.return_height
                           ? "the return to home is left out: so near home, some aircraft land "
                             "where they are"
                           : "the return to home is left out: its height is a setting of the "
                             "aircraft; give it with --return-height");
  }
  notes.push_back(mission.without_link == "goContinue"
                      ? std::string("when it loses its controller, the aircraft flies the mission "
                                    "on (goContinue)")
                      : fmt::format("what the aircraft does when it loses its controller ({}) is "
                                    "not looked at",
                                    mission.without_link));
  return notes;
}

ReadFlights read(std::istream& in, const ReadTask& task) {
  const DjiMission mission = read_dji_kmz(in, task.source);
  const DjiRules rules{task.how.placement.ground, task.how.rules.return_height,
                       task.how.rules.terrain, task.how.flier.allowance(true).x()};
  FlownDji flown =
      flown_dji(mission, task.how.placement.mission_frame(task.frame), rules, task.source);
  std::vector<std::string> notes = notes_of(mission, rules, flown);
  return {.flights = {{FlownMission(std::move(flown))}},
          .notes = std::move(notes),
          .vehicle = vehicle_of(mission.aircraft)};
}

// Of the turns that were asked for, those that became stops.
std::string note_of_stops(const DjiMission& mission) {
  std::vector<std::size_t> stops;
  const auto& waypoints = mission.waylines.front().waypoints;
  for (std::size_t i = 1; i + 1 < waypoints.size(); ++i) {
    if (waypoints[i].turn == DjiTurn::stop) stops.push_back(i);
  }
  if (stops.empty()) return "";
  return fmt::format(
      "no room to turn at {} of {} waypoints (counted from 0: {}{}): it stops there", stops.size(),
      waypoints.size(),
      fmt::join(stops.begin(), stops.begin() + std::min<long>(10, std::ssize(stops)), ", "),
      stops.size() > 10 ? ", …" : "");
}

// What is not proved of it.
std::string note_of_link(DjiLostLink lost_link) {
  switch (lost_link) {
    case DjiLostLink::go_back:
      return "when it loses its controller, the aircraft returns at the height that is set in it, "
             "by "
             "a way that is not proved (--lost-link continue flies the mission on)";
    case DjiLostLink::go_on:
      return "when it loses its controller, the aircraft flies the mission on";
    case DjiLostLink::land:
    case DjiLostLink::hover:
      return "when it loses its controller, the aircraft leaves the mission where it is";
  }
  return "";
}

void turn_everywhere(MissionTask& task, const geom::Polyline& legs) {
  if (task.options.turns) task.turns.assign(legs.size(), *task.options.turns);
}

// Turns without a stop that would be refused are made shorter, or stops.
bool turn_less(const WrittenMission&, const CheckResult& result, MissionTask& task) {
  if (!result.part || result.part->manoeuvre != Manoeuvre::corner) return false;
  if (result.part->item >= task.turns.size()) return false;
  double& most = task.turns[result.part->item];
  if (most == 0) return false;
  most = most > 2 * kDjiLeastTurn ? most / 2 : 0;
  return true;
}

// DJI does not say how its aircraft speed up and stop.
MissionEstimate least_time(const DjiMission& mission, const geom::Polyline& legs) {
  const DjiWayline& wayline = mission.waylines.front();
  MissionEstimate out{.autopilot = "dji", .at_least = true};
  for (std::size_t i = 1; i < legs.size(); ++i) {
    const DjiWaypoint& from = wayline.waypoints[i - 1];
    out.time.seconds += (legs[i] - legs[i - 1]).norm() / from.speed;
    ++out.time.waypoints;
    out.time.rests += wayline.waypoints[i].turn == DjiTurn::stop;
  }
  return out;
}

double climbs_at_most(const ExportOptions& options) {
  const DjiAirframe* airframe = airframe_of(options.dji.aircraft);
  return airframe ? std::max(airframe->climb, airframe->descent) : 0;
}

WrittenMission write(const MissionTask& task, const geom::Polyline& legs) {
  DjiOptions options = task.options.dji;
  options.home = task.ground;
  options.nose = task.options.placement.heading;
  if (const auto& stands = task.options.dji.takeoff) {
    options.takeoff = geom::to_enu(task.frame.axes, *stands);
    options.home = options.takeoff->z();
  }
  options.lands = task.options.lands;
  options.speed = task.options.speed ? task.options.speed : speed_along_legs(task);
  options.turns = task.turns;
  if (task.options.turns && options.turns.empty()) {
    options.turns.assign(legs.size(), *task.options.turns);
  }
  const MissionFrame over = task.options.placement.mission_frame(task.frame);
  require_near_origin(legs, over.origin, task.flight->id);
  const DjiMission mission = make_dji_mission(legs, over, options);
  geom::TextOutput text;
  write_dji_kmz(text, mission, task.checked ? "skyway" : "skyway (UNCHECKED)");
  WrittenMission written{text.str()};
  written.reading.placement = placement_to_read(task, over);
  written.note = note_of_link(options.lost_link);
  const std::string stops = task.options.turns ? note_of_stops(mission) : "";
  if (!stops.empty()) written.note += "; " + stops;
  written.estimates.push_back(least_time(mission, legs));
  return written;
}

}  // namespace

constinit const MissionFormat kDjiWpml{
    .format = {.word = "dji-wpml",
               .what = "a DJI mission (KMZ with WPML)",
               .begins = geom::any_of<geom::zip_with<"wpmz/">, geom::zip_with<".wpml">>,
               .readers = kDroneReaders},
    .may_be =
        [](std::string_view text) {
          return text_head(text).starts_with("PK") && text.find("wpmz/") != std::string_view::npos;
        },
    .read = read,
    .write = write,
    .prepare = turn_everywhere,
    .mend = turn_less,
    .reads_with = {FileOption::origin, FileOption::ground, FileOption::return_height,
                   FileOption::navigation, FileOption::tracking, FileOption::ground_model,
                   FileOption::surface_band},
    .writes_with = {FileOption::tolerance, FileOption::speed, FileOption::hover, FileOption::ground,
                    FileOption::origin, FileOption::wpml_version, FileOption::aircraft,
                    FileOption::turns, FileOption::start, FileOption::heading,
                    FileOption::lost_link, FileOption::gimbal, FileOption::navigation,
                    FileOption::tracking},
    .climbs_at_most = climbs_at_most,
    .has_legs = true,
    .is_binary = true,
    .rounding = kMissionRounding,
    .heights = FileHeights::absolute,
    .fastest = kDjiFastest,
    .fastest_because = "at most 15 m/s, as DJI's missions take"};

}  // namespace traj
