#pragma once

// waylines.wpml as a tree, and the mission that it says.

#include <string>

#include "traj/mission/dji/dji_mission.h"
#include "xml_element.h"

namespace traj {

// m/s: the least globalTransitionalSpeed that DJI documents. An aircraft may take it for less.
inline constexpr double kDjiSlowestTransit = 1;

// waypointTurnMode.
const char* name_of(DjiTurn turn);

// The version that the root's namespaces say ("1.0.6" of http://www.dji.com/wpmz/1.0.6). Throws
// geom::InputError(source, line, …) for another root, for namespaces that are not those of WPML
// 1.0.0 or 1.0.2 to 1.0.6 and KML 2.2, and for namespaces declared anywhere else.
std::string wpml_version(const XmlElement& root, const std::string& source);

// The take-off that a <wpml:missionConfig> was planned with, where it says one.
std::optional<geom::GeodeticPlace> planned_takeoff(const XmlElement& config,
                                                   const std::string& source);

// "longitude,latitude" of the <Point> of a Placemark, into the waypoint.
void read_wpml_point(const XmlElement& point, const std::string& source, DjiWaypoint& waypoint);

// Throws geom::InputError(source, line, …) as read_dji_wpml does.
DjiMission read_dji_waylines(const XmlElement& root, const std::string& source);

}  // namespace traj
