#include "writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "cli/run.h"
#include "geom/import/volume_keep_out.h"
#include "traj/drone_file/crazyflie.h"
#include "traj/drone_file/dji_wpml.h"
#include "traj/drone_file/geo_line.h"
#include "traj/drone_file/gltf_line.h"
#include "traj/drone_file/qgc_plan.h"
#include "traj/drone_file/setpoints.h"
#include "traj/drone_file/tello.h"
#include "traj/drone_file/wpl.h"

namespace exporting {
namespace {

using geom::Vec3;

std::string note_of(const Task& task) {
  return task.checked ? "" : "UNCHECKED: not compared with any map";
}

// As asked, else what the limits allow.
std::optional<double> speed_of(const Task& task) {
  return task.speed ? task.speed : speed_limit(task.limits);
}

// Where the nose points: as asked, as the trajectory's yaw begins, or north.
double heading_deg(const Task& task) {
  if (task.placement.heading) return *task.placement.heading;
  const auto& yaw = task.enu.segments.front().yaw;
  if (!yaw) return 0;
  const double degrees = std::remainder(90 - (*yaw)[0] * 180 / std::numbers::pi, 360);
  return std::round(degrees * 10) / 10;
}

Written write_tello(const Task& task, const geom::Polyline& legs) {
  const double speed = speed_of(task).value_or(1);
  if (speed < 0.1) {
    throw cli::UsageError(
        fmt::format("a Tello's legs are flown at 0.1 to 1 m/s, found {} m/s", speed));
  }
  cli::Placement placement = task.placement;
  placement.heading = heading_deg(task);
  const Vec3 ground(legs.front().x(), legs.front().y(), task.ground);
  const traj::TelloStart start = placement.tello_start(ground);
  const int centimetres = static_cast<int>(std::floor(100 * std::min(speed, 1.0) + 1e-9));
  const auto flight = traj::tello_flight(legs, start, centimetres, task.lands);
  std::ostringstream text;
  std::ostringstream python;
  std::ostringstream csv;
  traj::write_tello(text, flight);
  std::string note =
      fmt::format("Flight \"{}\".{}{}", task.id, task.checked ? "" : " ", note_of(task));
  std::replace_if(
      note.begin(), note.end(),
      [](char c) { return c == '"' || c == '\\' || static_cast<unsigned char>(c) < ' '; }, '\'');
  traj::write_tello_python(python, flight, start, note);
  traj::write_tello_csv(csv, flight, start);
  return {text.str(),
          python.str(),
          csv.str(),
          {},
          {"tello", placement, geom::to_enu(task.frame.axes, ground)}};
}

// To read the file again: over the origin that it was written for, whose height counts as known.
// A mission says where home is.
cli::Placement placement_of(const Task& task, const traj::MissionFrame& over) {
  cli::Placement placement = task.placement;
  placement.origin = over.origin;
  placement.ground.reset();
  return placement;
}

// Metres in which each autopilot slows down, with room for one that begins late.
double slowing_way(const Task& task, double speed) {
  double most = 0;
  for (const traj::Autopilot& one : task.autopilot.pilots) {
    most = std::max(most, traj::s_curve_length(one, speed));
  }
  return 1.5 * most + 5;
}

Written write_mission(const Task& task, const geom::Polyline& legs) {
  traj::MissionOptions options;
  options.home = task.ground;
  if (task.lands) options.landing_on = task.landing;
  options.speed = mission_speed(task);
  options.passed = task.passed;
  options.approach = task.approach;
  options.slowing = slowing_way(task, options.speed.value_or(0));
  const traj::MissionFrame over = task.placement.mission_frame(task.frame);
  cli::require_near_origin(legs, over.origin, task.id);
  const auto mission = traj::make_mission(legs, over, options);
  std::vector<std::size_t> points;
  for (const traj::MissionItem& item : mission.items) points.push_back(item.point);
  std::ostringstream text;
  if (task.format == "wpl") {
    traj::write_wpl(text, mission);
  } else {
    traj::write_qgc_plan(text, mission, task.checked ? "skyway" : "skyway (UNCHECKED)");
  }
  const cli::Placement placement = placement_of(task, over);
  Written written{text.str(), {}, {}, std::move(points), {task.format, placement, {}}};
  for (const traj::Autopilot& one : task.autopilot.pilots) {
    written.estimates.push_back({one.name, traj::mission_time(mission, one)});
  }
  return written;
}

// Of the turns that were asked for, those that became stops.
std::string note_of_stops(const traj::DjiMission& mission) {
  std::vector<std::size_t> stops;
  const auto& waypoints = mission.waylines.front().waypoints;
  for (std::size_t i = 1; i + 1 < waypoints.size(); ++i) {
    if (waypoints[i].turn == traj::DjiTurn::stop) stops.push_back(i);
  }
  if (stops.empty()) return "";
  return fmt::format(
      "no room to turn at {} of {} waypoints (counted from 0: {}{}): it stops there", stops.size(),
      waypoints.size(),
      fmt::join(stops.begin(), stops.begin() + std::min<long>(10, std::ssize(stops)), ", "),
      stops.size() > 10 ? ", …" : "");
}

Written write_dji(const Task& task, const geom::Polyline& legs) {
  traj::DjiOptions options = task.dji;
  options.home = task.ground;
  options.lands = task.lands;
  options.speed = speed_of(task);
  if (task.turns && options.turns.empty()) options.turns.assign(legs.size(), *task.turns);
  const traj::MissionFrame over = task.placement.mission_frame(task.frame);
  cli::require_near_origin(legs, over.origin, task.id);
  const traj::DjiMission mission = traj::make_dji_mission(legs, over, options);
  std::ostringstream text;
  traj::write_dji_kmz(text, mission, task.checked ? "skyway" : "skyway (UNCHECKED)");
  const cli::Placement placement = placement_of(task, over);
  Written written{text.str(), {}, {}, {}, {task.format, placement, {}}};
  if (task.turns) written.note = note_of_stops(mission);
  return written;
}

Written write_line(const Task& task, const geom::Polyline& legs) {
  std::ostringstream text;
  if (task.format == "gltf") {
    traj::write_gltf_line(text, legs, task.id, note_of(task));
    return {text.str(), {}, {}, {}, {task.format, task.placement, {}}};
  }
  const traj::MissionFrame over = task.placement.mission_frame(task.frame);
  cli::require_near_origin(legs, over.origin, task.id);
  const geom::GeographicFrame earth(over.origin);
  traj::GeoLine line{task.id, note_of(task), {}};
  for (const Vec3& p : legs) {
    line.points.push_back(earth.place(p));
    if (task.format == "kml") line.points.back().height -= over.geoid;
  }
  task.format == "kml" ? traj::write_kml(text, line) : traj::write_geojson(text, line);
  const cli::Placement placement = placement_of(task, over);
  return {text.str(), {}, {}, {}, {task.format, placement, {}}};
}

}  // namespace

bool knows_height(const Task& task) {
  return task.placement.origin || geom::knows_height(task.frame);
}

std::optional<double> speed_limit(const traj::Limits& limits) {
  std::optional<double> speed;
  for (const auto& limit : {limits[traj::Limit::speed], limits[traj::Limit::horizontal_speed],
                            limits[traj::Limit::vertical_speed]}) {
    if (limit) speed = std::min(speed.value_or(*limit), *limit);
  }
  return speed;
}

std::optional<double> mission_speed(const Task& task) {
  if (task.speed) return task.speed;
  traj::Limits limits = task.limits;
  double rate = 0;
  for (const traj::Autopilot& one : task.autopilot.pilots) {
    rate = std::max({rate, one.climb, one.descent});
  }
  std::optional<double>& vertical = limits[traj::Limit::vertical_speed];
  if (vertical && *vertical >= rate) vertical.reset();
  return speed_limit(limits);
}

bool has_legs(const std::string& format) {
  return format != "crazyflie" && format != "setpoints" && format != "volume4d";
}

void require_few_rows(double seconds, double rate) {
  constexpr double kMostRows = 1e7;  // 2 GB of text
  if (seconds * rate <= kMostRows) return;
  throw cli::UsageError(fmt::format(
      "--rate: expected at most {:g} setpoints in all, found {:.0f}; --rate {:g} or less fits",
      kMostRows, seconds * rate, kMostRows / seconds));
}

Written write(const Task& task, const geom::Polyline& legs) {
  std::ostringstream text;
  if (task.format == "crazyflie") {
    traj::write_crazyflie(text, task.enu);
    return {text.str(), {}, {}, {}, {task.format, task.placement, {}}};
  }
  if (task.format == "setpoints") {
    require_few_rows(traj::duration(task.enu), task.rate);
    traj::write_setpoints(text, traj::setpoints(task.enu, task.rate),
                          task.ned ? traj::SetpointAxes::ned : traj::SetpointAxes::enu);
    return {text.str(), {}, {}, {}, {task.format, task.placement, {}}};
  }
  if (task.format == "tello") return write_tello(task, legs);
  if (task.format == "dji-wpml") return write_dji(task, legs);
  if (task.format == "wpl" || task.format == "qgc-plan") return write_mission(task, legs);
  return write_line(task, legs);
}

}  // namespace exporting
