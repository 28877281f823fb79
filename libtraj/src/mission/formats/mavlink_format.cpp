#include "mavlink_format.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geom/base/error.h"
#include "geom/map/geographic_frame.h"
#include "geom/text/counted.h"

namespace traj {
namespace {

std::string terrain_note(const TerrainClaim& terrain) {
  return fmt::format(
      "heights above terrain count from home and from the autopilot's own terrain: what was looked "
      "at is a band of up to {:.1f} m, for terrain that is within {:g} m of the ground at posts "
      "{:g} "
      "m apart, a vehicle that is up to {:g} m behind it, and no rangefinder",
      terrain.band, terrain.error, terrain.spacing, terrain.lag);
}

// What the sea level is on the way, where a grid says it.
std::string sea_note(const FlownMavlink& read, const MissionFrame& over) {
  const geom::GeographicFrame earth(over.origin);
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const Vec3& p : read.path) {
    const geom::GeodeticPlace place = earth.place(p);
    const double sea = over.sea_level(place.latitude, place.longitude);
    least = std::min(least, sea);
    most = std::max(most, sea);
  }
  return fmt::format(
      "heights above the sea: the sea level is {:.2f} to {:.2f} m above the ellipsoid on the way, "
      "give or take {:.2f} m, which was looked at",
      least, most, over.sea_error());
}

// What its user should know of a mission.
std::vector<std::string> notes_of(const FlownMavlink& read) {
  std::vector<std::string> notes;
  if (!read.takes_off) {
    notes.emplace_back(
        "the mission has no take-off: how the vehicle comes to its first point is not looked at");
  }
  if (read.terrain) notes.push_back(terrain_note(*read.terrain));
  if (read.returns && read.terrain) {
    notes.emplace_back(
        "the return to home is not known: over terrain it must begin at a waypoint with a hold, be "
        "flown higher than it may begin (--return-height), and go home (no rally points)");
  } else if (read.returns) {
    notes.emplace_back(
        "the return to home is left out: its height is a setting of the vehicle, which "
        "--return-height gives, or it may go to the mission's own landing");
  }
  if (read.endless_jumps > 0) {
    notes.push_back(fmt::format(
        "{}: the mission does not end by itself, and what is repeated was looked at flown twice",
        geom::counted(read.endless_jumps, "jump for ever", "jumps for ever")));
  }
  if (read.tight_radii > 0) {
    notes.push_back(fmt::format(
        "{} a radius below {:g} m: PX4 from 1.12 on leaves the line before such an item by metres, "
        "which was looked at; a radius of {:g} m and a hold keep it on the line",
        geom::counted(read.tight_radii, "item has", "items have"), kLeastLineRadius,
        kLeastLineRadius));
  }
  if (read.above_terrain) {
    notes.emplace_back(
        "PX4 loads no mission with heights above terrain: it was looked at as ArduPilot flies it");
  } else if (read.not_for_px4 > 0) {
    notes.push_back(
        read.not_for_px4 == kTakeoff
            ? "the take-off is at latitude 0, longitude 0, where PX4 would fly to: the mission was "
              "looked at as ArduPilot flies it, which climbs on the spot"
            : fmt::format(
                  "PX4 loads no mission with command {}: it was looked at as ArduPilot flies it",
                  read.not_for_px4));
  }
  if (!read.ended) {
    notes.emplace_back("the flight ends without landing: the vehicle hovers, or the file was cut");
  }
  if (read.takeoff_from_home > 0) {
    notes.push_back(
        fmt::format("the take-off point is {:.3g} m from home: a climb at home and a flight from "
                    "there to it are assumed, and not every autopilot does that",
                    read.takeoff_from_home));
  }
  return notes;
}

// The speed along the legs, m/s: as asked, else what the limits allow. That on climbing and
// descending does not count where the autopilots keep it by themselves.
std::optional<double> mission_speed(const MissionTask& task) {
  if (task.options.speed) return task.options.speed;
  Limits limits = task.limits;
  double rate = 0;
  for (const Autopilot& one : task.options.flier.autopilots) {
    rate = std::max({rate, one.climb, one.descent});
  }
  std::optional<double>& vertical = limits[Limit::vertical_speed];
  if (vertical && *vertical >= rate) vertical.reset();
  return speed_limit(limits);
}

// Metres in which each autopilot slows down, with room for one that begins late.
double slowing_way(const MissionTask& task, double speed) {
  double most = 0;
  for (const Autopilot& one : task.options.flier.autopilots) {
    most = std::max(most, s_curve_length(one, speed));
  }
  return 1.5 * most + 5;
}

}  // namespace

ReadFlights fly_mission(const Mission& mission, const ReadTask& task) {
  // MAVLink counts them in 16 bits, and home is one more.
  constexpr std::size_t kMostSent = 65534;
  if (mission.items.size() > kMostSent) {
    throw geom::InputError(
        task.source,
        {.expected = fmt::format("at most {} items, as MAVLink sends no more", kMostSent),
         .found = fmt::to_string(mission.items.size())});
  }
  MissionRules rules = task.how.flier.rules(task.how.rules);
  rules.home = task.how.placement.ground;
  const MissionFrame over = task.how.placement.mission_frame(task.frame);
  FlownMavlink flown = flown_mission(mission, over, rules, task.source);
  std::vector<std::string> notes = notes_of(flown);
  if (flown.counts_from_sea && over.geoid_grid) notes.push_back(sea_note(flown, over));
  if (mission.first_for_home) {
    notes.insert(notes.begin(),
                 "its first item is not home (frame 0, command 16), and ArduPilot and "
                 "QGroundControl do not fly it: the mission was looked at as PX4 flies all items");
  }
  notes.insert(notes.begin(), mission.notes.begin(), mission.notes.end());
  return {{{FlownMission(std::move(flown))}}, std::move(notes)};
}

namespace {

// Rally points as the file will hold them: whole 1e-7 degrees, heights above home in millimetres.
std::vector<geom::GeodeticPlace> rally_of(const MissionTask& task,
                                          const geom::GeodeticOrigin& origin) {
  const geom::GeographicFrame earth(origin);
  std::vector<geom::GeodeticPlace> out;
  for (const Vec3& place : task.options.rally) {
    const Vec3 enu = geom::to_enu(task.frame.axes, place);
    geom::GeodeticPlace& rally = out.emplace_back(earth.place(enu));
    rally.latitude = std::round(rally.latitude * 1e7) / 1e7;
    rally.longitude = std::round(rally.longitude * 1e7) / 1e7;
    rally.height = std::round((enu.z() - task.ground) * 1e3) / 1e3;
  }
  return out;
}

}  // namespace

WrittenMission write_mission(const MissionTask& task, const geom::Polyline& legs,
                             WrittenMission (*write)(const Mission&, const MissionTask&)) {
  MissionOptions options;
  options.home = task.ground;
  if (task.options.lands) options.landing_on = task.landing;
  options.speed = mission_speed(task);
  options.passed = task.passed;
  options.approach = task.approach;
  options.slowing = slowing_way(task, options.speed.value_or(0));
  const MissionFrame over = task.options.placement.mission_frame(task.frame);
  require_near_origin(legs, over.origin, task.flight->id);
  Mission mission = make_mission(legs, over, options);
  mission.fences = task.options.fences;
  mission.rally = rally_of(task, over.origin);
  WrittenMission written = write(mission, task);
  for (const MissionItem& item : mission.items) written.points.push_back(item.point);
  written.reading.placement = placement_to_read(task, over);
  for (const Autopilot& one : task.options.flier.autopilots) {
    written.estimates.push_back({one.name, mission_time(mission, one)});
  }
  return written;
}

void pass_all(MissionTask& task, const geom::Polyline& legs) {
  constexpr std::size_t kMostTried = 200;
  task.passed.assign(legs.size(), legs.size() <= kMostTried);
  task.approach.assign(legs.size(), 0);
}

bool rest_or_slow_down(const WrittenMission& written, const CheckResult& result,
                       MissionTask& task) {
  constexpr double kSlowest = 1;  // m/s
  if (!result.part || result.part->item < 1 || result.part->item > written.points.size()) {
    return false;
  }
  const std::size_t point = written.points[result.part->item - 1];
  const Manoeuvre manoeuvre = result.part->manoeuvre;
  if (manoeuvre == Manoeuvre::corner && task.passed[point]) {
    task.passed[point] = false;
    return true;
  }
  const bool overshoots = manoeuvre == Manoeuvre::overshoot || manoeuvre == Manoeuvre::landing;
  const double usual = mission_speed(task).value_or(0);
  double& speed = task.approach[point];
  if (!overshoots || result.strayed.empty() || usual <= kSlowest || speed == kSlowest) return false;
  speed = std::max(kSlowest, (speed > 0 ? speed : std::min(usual, 8.0)) / 2);
  return true;
}

}  // namespace traj
