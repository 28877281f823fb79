#pragma once

// Texts of DJI's WPML, with a part of them changed.

#include <string>

namespace traj::testing {

inline std::string in_kml(const std::string& inside, const std::string& version = "1.0.6") {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<kml xmlns=\"http://www.opengis.net/kml/2.2\" "
         "xmlns:wpml=\"http://www.dji.com/wpmz/" +
         version + "\"><Document>\n" + inside + "</Document></kml>\n";
}

inline std::string element(const std::string& name, const std::string& inside) {
  return "<wpml:" + name + ">" + inside + "</wpml:" + name + ">\n";
}

// Of a mission above 47 north, 8 east, on ground at 400 m.
inline std::string dji_config(const std::string& more = "", const std::string& finish = "noAction",
                              const std::string& approach = "safely",
                              const std::string& drone = "77") {
  return element("missionConfig",
                 element("flyToWaylineMode", approach) + element("finishAction", finish) +
                     element("exitOnRCLost", "goContinue") +
                     element("takeOffSecurityHeight", "20") +
                     element("globalTransitionalSpeed", "9") +
                     element("droneInfo", element("droneEnumValue", drone)) + more);
}

inline std::string dji_takeoff(const std::string& place = "47,8,400") {
  return element("takeOffRefPoint", place);
}

inline std::string dji_turn(const std::string& mode = "toPointAndStopWithDiscontinuityCurvature",
                            const std::string& damping = "0") {
  return element("waypointTurnParam",
                 element("waypointTurnMode", mode) + element("waypointTurnDampingDist", damping));
}

inline std::string dji_waypoint(int index, const std::string& place, const std::string& height,
                                const std::string& more = dji_turn()) {
  return "<Placemark><Point><coordinates>\n " + place + "\n</coordinates></Point>\n" +
         element("index", std::to_string(index)) + element("executeHeight", height) + more +
         "</Placemark>\n";
}

inline std::string dji_folder(const std::string& waypoints,
                              const std::string& heights = "relativeToStartPoint",
                              const std::string& more = "", const std::string& id = "0") {
  return "<Folder>\n" + element("templateId", id) + element("executeHeightMode", heights) +
         element("waylineId", id) + element("autoFlightSpeed", "4") + more + waypoints +
         "</Folder>\n";
}

// Two waypoints about 76 m apart, to the east.
inline std::string dji_leg() {
  return dji_waypoint(0, "8,47", "30") + dji_waypoint(1, "8.001,47", "35");
}

inline std::string dji_template_folder(const std::string& waypoints, const std::string& more = "",
                                       const std::string& heights = "relativeToStartPoint") {
  return "<Folder>\n" + element("templateType", "waypoint") + element("templateId", "0") +
         element("waylineCoordinateSysParam", element("heightMode", heights)) +
         element("globalWaypointTurnMode", "toPointAndStopWithDiscontinuityCurvature") +
         element("globalHeight", "30") + more + waypoints + "</Folder>\n";
}

inline std::string dji_template_waypoint(int index, const std::string& place,
                                         const std::string& more) {
  return "<Placemark><Point><coordinates>" + place + "</coordinates></Point>\n" +
         element("index", std::to_string(index)) + more + "</Placemark>\n";
}

}  // namespace traj::testing
