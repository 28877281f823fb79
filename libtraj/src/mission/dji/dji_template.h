#pragma once

// template.kml: what apps show, and make waylines of anew.

#include <string>

#include "traj/mission/dji/dji_mission.h"
#include "xml_element.h"

namespace traj {

// Takes the take-off that was planned with from the template where the mission has none. Throws
// geom::InputError(source, line, …) for a template of waypoints that says another flight than the
// mission's (an app that opens it would replace the one that is checked), and for calibration
// flights. Other templates (areas, strips) are made into waylines by the app alone.
void hold_against_template(const XmlElement& root, const std::string& source, DjiMission& mission);

}  // namespace traj
