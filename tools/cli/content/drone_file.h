#pragma once

// Files that drones and ground stations read, as what they make a vehicle fly over a map.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/option/autopilot_option.h"
#include "geom/map/frame.h"
#include "traj/drone_file/mission.h"
#include "traj/drone_file/mission_flight.h"
#include "traj/drone_file/tello.h"
#include "traj/proof/flown.h"

namespace cli {

// Where a file's coordinates count from, where the file does not say.
struct Placement {
  std::optional<geom::GeodeticOrigin> origin;  // --origin; default: the map's
  double geoid = 0;                            // --geoid, m
  std::optional<double> ground;                // --ground, m in the map's z
  double takeoff_height = 1;                   // --takeoff-height, m
  std::optional<double> heading;               // --heading, degrees clockwise from north

  void add_origin_to(CLI::App& app);  // --origin and --geoid
  void add_ground_to(CLI::App& app);  // --ground
  void add_to(CLI::App& app);         // all

  // Its height is known where --origin gives it, or the frame (geom::knows_height). Throws
  // UsageError where neither the options nor the frame know the origin.
  traj::MissionFrame mission_frame(const geom::Frame& frame) const;
  traj::TelloStart tello_start(const geom::Vec3& enu_ground) const;
};

// One flight of a file.
struct DroneFile {
  std::string id;
  std::string format;
  traj::Flown flown;               // in the map's axes
  std::vector<std::string> notes;  // what its user should know before flying it, for warnings
};

// Throws geom::InputError(id, …) for a point (east, north, up) that is further than 200 km from the
// origin: coordinates of a projection, taken as metres from a place, would put home elsewhere.
void require_near_origin(const geom::Polyline& enu, const geom::GeodeticOrigin& origin,
                         const std::string& id);

struct DroneFileOptions {
  std::string format;  // empty: not asked for
  Placement placement;
  std::optional<geom::Vec3> start;  // where a Tello stands, in the map's axes
  traj::MissionRules mission = {};  // but for home, which is the placement's ground
  AutopilotOptions autopilot = {};
  // Where it is set, read_drone_file() refuses what the format of the file does not use.
  const CLI::App* app = nullptr;

  // --file-format, --paths-csv, --start, those of the placement and all of missions; sets `app`.
  void add_to(CLI::App& parser);
  void add_mission_to(CLI::App& app);  // all of missions
  void add_heights_to(CLI::App& app);  // --return-height and --terrain of missions

  // Throws UsageError for an option of the app that this format does not use (format_options.h):
  // one of drone files, "records" or "flight-log".
  void require_used(std::string_view of_format, std::string_view because) const;
};

// All that is in a file of this text: one flight, or of lines (KML, GeoJSON, glTF) and tables of
// paths ("paths-csv") several, at least one. The id is the file's name without folder and
// extension, with -1, -2, … where there are several, or the table's. Throws geom::InputError for
// bad text and for what cannot be flown or is not known, UsageError where an option is missing.
std::vector<DroneFile> read_drone_file(const std::string& text, const std::string& source,
                                       const DroneFileOptions& options, const geom::Frame& frame);

}  // namespace cli
