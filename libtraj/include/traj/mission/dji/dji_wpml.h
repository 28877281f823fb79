#pragma once

// DJI missions as files: KMZ archives with WPML.
//
// Example:
//   const traj::MissionFrame frame{.origin = {47.4, 8.5, 400}};
//   const std::vector<geom::Vec3> points = {{0, 0, 30}, {80, 0, 30}};
//   std::stringstream file;
//   traj::write_dji_kmz(file, traj::make_dji_mission(points, frame, {}), "me");
//   assert(traj::read_dji_kmz(file, "mission.kmz").waylines[0].waypoints.size() == 2);
//
// They hold `wpmz/template.kml` and `wpmz/waylines.wpml` of WPML 1.0.0 and 1.0.2 to 1.0.6. Format:
// DJI's cloud API documentation, "DJI WPML".

#include <iosfwd>
#include <string_view>

#include "traj/mission/dji/dji_mission.h"

namespace traj {

// `author` goes into the template. The mission must be one of make_dji_mission.
void write_dji_kmz(std::ostream& out, const DjiMission& mission, std::string_view author);

// Throws geom::InputError(source, …) if it is no whole KMZ with waylines.wpml, for another
// version, and as read_dji_wpml does.
DjiMission read_dji_kmz(std::istream& in, std::string_view source);

// The mission of waylines.wpml, which the aircraft executes. The template, which apps make waylines
// of, may be empty: no template. Throws geom::InputError(source/file, line, …) for text that is not
// WPML; for elements that are missing, twice, of values out of their range or not known; for what
// moves the aircraft in a way that is not known (curved legs, detours,
// calibration flights, actions that are not of cameras, gimbals, yaw or rest); and for a template
// of waypoints that says another flight.
DjiMission read_dji_wpml(std::string_view waylines, std::string_view template_kml,
                         std::string_view source);

}  // namespace traj
