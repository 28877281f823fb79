#include "drone_file.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <numbers>
#include <sstream>

#include "cli/answer/exit.h"
#include "cli/content/dji_file.h"
#include "cli/option/format_options.h"
#include "cli/option/numbers_option.h"
#include "geom/base/error.h"
#include "geom/import/volume_keep_out.h"
#include "geom/record/path_csv.h"
#include "geom/text/counted.h"
#include "traj/curve/to_enu.h"
#include "traj/drone_file/crazyflie.h"
#include "traj/drone_file/geo_line.h"
#include "traj/drone_file/gltf_line.h"
#include "traj/drone_file/mission_flight.h"
#include "traj/drone_file/qgc_plan.h"
#include "traj/drone_file/setpoints.h"
#include "traj/drone_file/wpl.h"

namespace cli {
namespace {

constexpr double kGeodesy = 1e-8;  // m: what a projection may be off by

// What skyway-check and skyway-import-trajectory read.
const std::array kFormatOptions{
    FormatOption{"--start", {"tello"}},
    FormatOption{"--takeoff-height", {"tello"}},
    FormatOption{"--heading", {"tello"}},
    FormatOption{"--origin", {"wpl", "qgc-plan", "dji-wpml", "kml", "geojson"}},
    FormatOption{"--geoid", {"wpl", "qgc-plan", "kml"}},
    FormatOption{"--ground", {"wpl", "qgc-plan", "dji-wpml"}},
    FormatOption{"--return-height", {"wpl", "qgc-plan", "dji-wpml"}},
    FormatOption{"--terrain", {"wpl", "qgc-plan"}},
    FormatOption{"--acceptance", {"wpl", "qgc-plan"}},
    FormatOption{"--braking", {"wpl", "qgc-plan"}},
    FormatOption{"--autopilot", {"wpl", "qgc-plan"}},
    FormatOption{"--params", {"wpl", "qgc-plan"}},
    FormatOption{"--drag", {"wpl", "qgc-plan"}},
    FormatOption{"--navigation",
                 {"crazyflie", "setpoints", "tello", "wpl", "qgc-plan", "dji-wpml", "kml",
                  "geojson", "gltf"}},
    FormatOption{"--tracking",
                 {"crazyflie", "setpoints", "tello", "dji-wpml", "kml", "geojson", "gltf"}},
    FormatOption{"--gap", {"crazyflie"}},
    FormatOption{"--metres", {"records", "flight-log", "paths-csv"}}};

// What a text is, by how it begins.
std::string detected(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  if (text.starts_with("QGC WPL")) return "wpl";
  if (text.starts_with("{")) {
    const bool geojson =
        text.find("\"fileType\"") == text.npos && text.find("\"coordinates\"") != text.npos;
    return geojson ? "geojson" : "qgc-plan";
  }
  if (text.starts_with("glTF")) return "gltf";
  if (text.starts_with("PK")) return "dji-wpml";
  if (text.starts_with("<")) return "kml";
  if (text.starts_with("command") || text.starts_with("takeoff")) return "tello";
  if (text.starts_with("duration") || text.starts_with("Duration")) return "crazyflie";
  if (text.starts_with("t_s,")) return "setpoints";
  return "paths-csv";
}

using Notes = std::vector<std::string>;

traj::Flown flown_tello(std::istream& in, const std::string& source,
                        const DroneFileOptions& options, geom::Axes axes, Notes& notes) {
  if (!options.start) {
    throw UsageError(
        "a Tello script does not say where it starts: give --start x,y,z, the place where the "
        "drone stands");
  }
  const traj::TelloFlight flight = traj::read_tello(in, source);
  if (!flight.lands)
    notes.emplace_back("the flight ends without landing: the drone hovers, or the file was cut");
  const auto start = options.placement.tello_start(geom::to_enu(axes, *options.start));
  traj::Flown flown;
  flown.path = traj::tello_path(flight, start);
  flown.ends.takeoff_from = start.ground.z();
  flown.envelope = traj::kTelloEnvelope;
  flown.airborne = traj::tello_times(flight, start).back();
  for (const traj::TelloLeg& leg : flight.legs) {
    flown.speed = std::max(flown.speed.value_or(0), 0.01 * leg.speed);
  }
  return flown;
}

// What its user should know of a mission.
Notes notes_of(const traj::FlownMission& read) {
  Notes notes;
  if (!read.takes_off) {
    notes.emplace_back(
        "the mission has no take-off: how the vehicle comes to its first point is not looked at");
  }
  if (read.returns) {
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
        geom::counted(read.tight_radii, "item has", "items have"), traj::kLeastLineRadius,
        traj::kLeastLineRadius));
  }
  if (read.not_for_px4 > 0) {
    notes.push_back(
        read.not_for_px4 == traj::kTakeoff
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

traj::Flown flown_mission(const traj::Mission& mission, const std::string& source,
                          const DroneFileOptions& options, const geom::Frame& frame, Notes& notes) {
  const Placement& placement = options.placement;
  traj::MissionRules rules = options.autopilot.rules(options.mission);
  rules.home = placement.ground;
  traj::FlownMission read =
      traj::flown_mission(mission, placement.mission_frame(frame), rules, source);
  notes = notes_of(read);
  notes.insert(notes.begin(), mission.notes.begin(), mission.notes.end());
  traj::Flown flown;
  flown.path = std::move(read.path);
  flown.hold = std::move(read.hold);
  flown.legs = std::move(read.legs);
  flown.sweeps = std::move(read.sweeps);
  flown.drift = std::move(read.drift);
  flown.fences = std::move(read.fences);
  flown.home = read.home;
  flown.rally = std::move(read.rally);
  flown.touches = std::move(read.touches);
  flown.idle_items = read.idle_items;
  flown.corners = read.corners;
  flown.acceptance = read.acceptance;
  flown.ends = read.ends;
  flown.speed = read.speed;
  flown.returns = read.returns;
  flown.path_stray = traj::kMissionStray;
  flown.endless_jumps = read.endless_jumps;
  flown.climb = read.climb;
  flown.descent = read.descent;
  return flown;
}

geom::Polyline on_map(const traj::GeoPoints& places, const traj::MissionFrame& frame, double geoid,
                      std::string_view source) {
  if (!frame.height_known) {
    throw geom::InputError(source, {.says = "its heights are above the sea or the ellipsoid, and "
                                            "the map does not say how high its z = 0 is",
                                    .advice = "give --origin latitude,longitude,height"});
  }
  const geom::GeographicFrame earth(frame.origin);
  geom::Polyline path;
  for (geom::GeodeticPlace place : places) {
    if (!traj::is_near(frame.origin, place.latitude, place.longitude)) {
      throw geom::InputError(
          source,
          {.expected = fmt::format("a place near the origin, latitude {} longitude {}",
                                   frame.origin.latitude, frame.origin.longitude),
           .found = fmt::format("latitude {} longitude {}", place.latitude, place.longitude)});
    }
    place.height += geoid;
    path.push_back(earth.enu(place));
  }
  return path;
}

std::vector<traj::Flown> on_map(const std::vector<traj::GeoPoints>& lines,
                                const traj::MissionFrame& frame, double geoid,
                                std::string_view source) {
  std::vector<traj::Flown> flown(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    flown[i].path = on_map(lines[i], frame, geoid, source);
    flown[i].path_stray = geom::Vec3(kGeodesy, kGeodesy, 0);
  }
  return flown;
}

// In ENU.
std::vector<traj::Flown> read_flown(std::istream& in, const std::string& source,
                                    const std::string& format, const DroneFileOptions& options,
                                    const geom::Frame& frame, Notes& notes) {
  const auto over = [&] { return options.placement.mission_frame(frame); };
  if (format == "kml") return on_map(traj::read_kml(in, source), over(), over().geoid, source);
  if (format == "geojson") return on_map(traj::read_geojson(in, source), over(), 0, source);
  if (format == "gltf") {
    std::vector<traj::Flown> flown;
    for (geom::Polyline& line : traj::read_gltf_lines(in, source)) {
      flown.emplace_back().path = std::move(line);
    }
    return flown;
  }
  traj::Flown flown;
  if (format == "crazyflie") {
    traj::CrazyflieFlight flight = traj::read_crazyflie(in, source);
    flown.trajectory = std::move(flight.trajectory);
    flown.stray = std::move(flight.stray);
  } else if (format == "setpoints") {
    flown.setpoints = traj::read_setpoints(in, source);
    flown.trajectory = traj::straight_between(flown.setpoints);
  } else if (format == "tello") {
    flown = flown_tello(in, source, options, frame.axes, notes);
  } else if (format == "dji-wpml") {
    flown = flown_dji_file(in, source, options, frame, notes);
  } else if (format == "wpl") {
    flown = flown_mission(traj::read_wpl(in, source), source, options, frame, notes);
  } else {
    flown = flown_mission(traj::read_qgc_plan(in, source), source, options, frame, notes);
  }
  return {flown};
}

traj::Flown in_map_axes(traj::Flown flown, geom::Axes axes) {
  flown.trajectory = traj::to_enu(axes, std::move(flown.trajectory));
  flown.path = traj::to_enu(axes, std::move(flown.path));
  flown.path_stray = geom::to_enu(axes, flown.path_stray);
  for (traj::Sweep& sweep : flown.sweeps) sweep.hull = traj::to_enu(axes, std::move(sweep.hull));
  for (traj::Drift& drift : flown.drift) {
    for (traj::Sweep& sweep : drift.sweeps) sweep.hull = traj::to_enu(axes, std::move(sweep.hull));
    drift.around = geom::to_enu(axes, drift.around);
  }
  flown.navigation = geom::to_enu(axes, flown.navigation);
  for (traj::Fence& fence : flown.fences) {
    for (geom::Vec2& p : fence.ring) p = geom::to_enu(axes, {p.x(), p.y(), 0}).head<2>();
  }
  if (flown.home) flown.home = geom::to_enu(axes, *flown.home);
  for (geom::Vec3& p : flown.rally) p = geom::to_enu(axes, p);
  for (geom::Vec3& p : flown.touches) p = geom::to_enu(axes, p);
  for (traj::Stray& stray : flown.stray) stray.position = geom::to_enu(axes, stray.position);
  for (traj::Setpoint& s : flown.setpoints) {
    s.yaw = geom::yaw_to_enu(axes, s.yaw);
    if (axes != geom::Axes::enu) s.yaw_rate = -s.yaw_rate;
    for (geom::Vec3* v : {&s.state.position, &s.state.velocity, &s.state.acceleration}) {
      *v = geom::to_enu(axes, *v);
    }
  }
  return flown;
}

std::vector<DroneFile> read_paths(std::istream& in, const std::string& source) {
  std::vector<DroneFile> files;
  for (geom::PathRecord& record : geom::read_path_csv(in, source)) {
    files.push_back({std::move(record.id), "paths-csv", {}, {}});
    files.back().flown.path = std::move(record.points);
  }
  return files;
}

}  // namespace

void Placement::add_origin_to(CLI::App& app) {
  app.add_option_function<std::string>(
         "--origin",
         [this](const std::string& text) {
           const auto v = parse_numbers(text, 3);
           if (!v || std::abs((*v)[0]) > 90 || std::abs((*v)[1]) > 180) {
             throw CLI::ValidationError(
                 "--origin", "expected latitude,longitude,height, found \"" + text + '"');
           }
           origin = geom::GeodeticOrigin{(*v)[0], (*v)[1], (*v)[2]};
         },
         "where on Earth the map's (0, 0, 0) is: degrees, and metres above the ellipsoid (default: "
         "what the map says)")
      ->type_name("LAT,LON,HEIGHT");
  app.add_option("--geoid", geoid,
                 "height of the sea level there above the ellipsoid, metres; converts heights "
                 "above the sea (default 0)")
      ->check(CLI::Range(-200.0, 200.0));
}

void Placement::add_ground_to(CLI::App& app) {
  app.add_option("--ground", ground, "height of the ground at the take-off, in the map's z")
      ->check(CLI::Range(-1e6, 1e6));
}

void Placement::add_to(CLI::App& app) {
  add_origin_to(app);
  add_ground_to(app);
  app.add_option("--takeoff-height", takeoff_height,
                 "metres above the ground to which a Tello rises on take-off (default 1)")
      ->check(CLI::Range(0.2, 10.0));
  app.add_option("--heading", heading,
                 "where a Tello's nose points on the ground, degrees clockwise from north")
      ->check(CLI::Range(-360.0, 360.0));
}

traj::MissionFrame Placement::mission_frame(const geom::Frame& frame) const {
  if (origin) {
    geom::Frame placed = frame;
    placed.origin = origin;
    if (!geom::counts_from_origin(placed)) {
      throw UsageError(
          fmt::format("the map has the coordinates of \"{}\", which do not count from a place, so "
                      "--origin cannot say where they are: make the map from data in metres about "
                      "that place",
                      frame.crs.substr(0, 60)));
    }
    return {*origin, geoid, true};
  }
  if (!geom::counts_from_origin(frame)) {
    throw UsageError("the map has no origin on Earth: give --origin latitude,longitude,height");
  }
  return {*frame.origin, geoid, geom::knows_height(frame)};
}

void require_near_origin(const geom::Polyline& enu, const geom::GeodeticOrigin& origin,
                         const std::string& id) {
  constexpr double kFurthest = 2e5;  // metres
  for (const geom::Vec3& p : enu) {
    if (p.head<2>().norm() <= kFurthest) continue;
    throw geom::InputError(
        id,
        {.expected = fmt::format("a flight within 200 km of the origin, latitude {}, longitude {}",
                                 origin.latitude, origin.longitude),
         .found = fmt::format("[{}, {}] m from it", p.x(), p.y()),
         .advice = "give the origin from which the map's coordinates count"});
  }
}

traj::TelloStart Placement::tello_start(const geom::Vec3& enu_ground) const {
  return {enu_ground, heading.value_or(0) * std::numbers::pi / 180, takeoff_height};
}

void DroneFileOptions::add_to(CLI::App& parser) {
  app = &parser;
  parser
      .add_option("--file-format", format,
                  "FILE is a drone file, to be checked as it will be flown; auto: found out from "
                  "its beginning")
      ->check(CLI::IsMember({"auto", "crazyflie", "setpoints", "tello", "wpl", "qgc-plan",
                             "dji-wpml", "kml", "geojson", "gltf", "paths-csv", "flight-log"}));
  parser.add_flag_callback(
      "--paths-csv", [this] { format = "paths-csv"; },
      "FILE is a table of paths with columns id,x,y,z");
  add_point(parser, "--start", start,
            "where a Tello stands before it takes off, along the map's axes");
  placement.add_to(parser);
  add_mission_to(parser);
  autopilot.add_to(parser);
  autopilot.add_tracking_to(parser);
}

void DroneFileOptions::require_used(std::string_view of_format, std::string_view because) const {
  if (app) cli::require_used(*app, kFormatOptions, of_format, because);
}

void DroneFileOptions::add_mission_to(CLI::App& parser) {
  parser
      .add_option("--acceptance", mission.acceptance,
                  "a mission's vehicle may turn so many metres before a waypoint where it does not "
                  "rest, 0: not at all (default: 2, or 10 where the item says nothing); never less "
                  "than the item says")
      ->check(CLI::Range(0.0, 1e4));
  parser
      .add_option("--braking", mission.braking,
                  "how hard it brakes, m/s2: what it needs more than that distance is looked at "
                  "beyond the waypoint (default 3)")
      ->check(CLI::Range(0.1, 100.0));
  add_heights_to(parser);
}

void DroneFileOptions::add_heights_to(CLI::App& parser) {
  parser
      .add_option("--return-height", mission.return_height,
                  "metres above home at which a mission's return is flown; without it, a mission "
                  "with a return fails the check")
      ->check(CLI::Range(0.0, 1e4));
  parser
      .add_option("--terrain", mission.ground,
                  "height of flat ground in the map's z, from which a mission's heights above "
                  "terrain count")
      ->check(CLI::Range(-1e6, 1e6));
}

std::vector<DroneFile> read_drone_file(const std::string& text, const std::string& source,
                                       const DroneFileOptions& options, const geom::Frame& frame) {
  std::istringstream in(text);
  const std::string format = options.format == "auto" ? detected(text) : options.format;
  if (text.starts_with("id,t_s,")) {
    throw geom::InputError(
        source,
        {.says =
             "this is a flight log: skyway-check --file-format flight-log holds it against a map"});
  }
  options.require_used(format, read_as(source, format));
  if (format == "paths-csv") return read_paths(in, source);
  Notes notes;
  auto read = read_flown(in, source, format, options, frame, notes);
  const std::string name = std::filesystem::path(source).stem().string();
  std::vector<DroneFile> files;
  for (std::size_t i = 0; i < read.size(); ++i) {
    const std::string id = read.size() == 1 ? name : fmt::format("{}-{}", name, i + 1);
    read[i].navigation = options.autopilot.allowance(read[i].drift.empty());
    files.push_back({id, format, in_map_axes(std::move(read[i]), frame.axes), notes});
  }
  return files;
}

}  // namespace cli
