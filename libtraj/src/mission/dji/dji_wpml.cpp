#include "traj/mission/dji/dji_wpml.h"

#include <fmt/format.h>

#include <array>
#include <istream>
#include <iterator>
#include <ostream>

#include "dji_template.h"
#include "dji_waylines.h"
#include "geom/archive/small_zip.h"
#include "geom/base/error.h"
#include "geom/text/markup.h"
#include "geom/text/number.h"
#include "xml_element.h"

namespace traj {
namespace {

constexpr const char* kWaylines = "wpmz/waylines.wpml";
constexpr const char* kTemplate = "wpmz/template.kml";

std::string shortest(double value) {
  std::string text;
  geom::append_number(text, value);
  return text;
}

const char* finish_of(const DjiMission& mission) {
  return mission.finish == DjiFinish::land ? "autoLand" : "noAction";
}

std::string head(const DjiMission& mission) {
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<kml xmlns=\"http://www.opengis.net/kml/2.2\" xmlns:wpml=\"http://www.dji.com/wpmz/{}\">\n"
      "<Document>\n",
      mission.version);
}

// Its own camera, which actions of the gimbal are for.
std::string payload(const DjiMission& mission) {
  if (!mission.gimbal) return "";
  for (const NamedDjiAircraft& known : kDjiAircraft) {
    if (known.aircraft != mission.aircraft) continue;
    return fmt::format(
        "<wpml:payloadInfo>\n"
        "<wpml:payloadEnumValue>{}</wpml:payloadEnumValue>\n"
        "<wpml:payloadPositionIndex>0</wpml:payloadPositionIndex>\n"
        "</wpml:payloadInfo>\n",
        known.camera);
  }
  return "";
}

std::string config(const DjiMission& mission) {
  const geom::GeodeticPlace& takeoff = *mission.takeoff;
  const bool goes_on = mission.without_link == "goContinue";
  return fmt::format(
      "<wpml:missionConfig>\n"
      "<wpml:flyToWaylineMode>safely</wpml:flyToWaylineMode>\n"
      "<wpml:finishAction>{}</wpml:finishAction>\n"
      "<wpml:exitOnRCLost>{}</wpml:exitOnRCLost>\n"
      "<wpml:executeRCLostAction>{}</wpml:executeRCLostAction>\n"
      "<wpml:takeOffSecurityHeight>{}</wpml:takeOffSecurityHeight>\n"
      "<wpml:takeOffRefPoint>{:.9f},{:.9f},{:.3f}</wpml:takeOffRefPoint>\n"
      "<wpml:globalTransitionalSpeed>{}</wpml:globalTransitionalSpeed>\n"
      "<wpml:droneInfo>\n"
      "<wpml:droneEnumValue>{}</wpml:droneEnumValue>\n"
      "<wpml:droneSubEnumValue>{}</wpml:droneSubEnumValue>\n"
      "</wpml:droneInfo>\n"
      "{}"
      "</wpml:missionConfig>\n",
      finish_of(mission), goes_on ? "goContinue" : "executeLostAction",
      goes_on ? "hover" : mission.without_link, shortest(mission.security_height), takeoff.latitude,
      takeoff.longitude, takeoff.height, shortest(mission.transit_speed), mission.aircraft.type,
      mission.aircraft.kind, payload(mission));
}

// Where the nose points.
std::string heading(const DjiMission& mission) {
  if (!mission.nose) {
    return "<wpml:waypointHeadingMode>followWayline</wpml:waypointHeadingMode>\n";
  }
  return fmt::format(
      "<wpml:waypointHeadingMode>smoothTransition</wpml:waypointHeadingMode>\n"
      "<wpml:waypointHeadingAngle>{}</wpml:waypointHeadingAngle>\n"
      "<wpml:waypointHeadingPathMode>followBadArc</wpml:waypointHeadingPathMode>\n",
      shortest(std::remainder(*mission.nose, 360)));
}

// At the first waypoint; the gimbal stays so.
std::string gimbal(const DjiMission& mission, std::size_t index) {
  if (!mission.gimbal || index > 0) return "";
  return fmt::format(
      "<wpml:actionGroup>\n"
      "<wpml:actionGroupId>0</wpml:actionGroupId>\n"
      "<wpml:actionGroupStartIndex>0</wpml:actionGroupStartIndex>\n"
      "<wpml:actionGroupEndIndex>0</wpml:actionGroupEndIndex>\n"
      "<wpml:actionGroupMode>sequence</wpml:actionGroupMode>\n"
      "<wpml:actionTrigger>\n"
      "<wpml:actionTriggerType>reachPoint</wpml:actionTriggerType>\n"
      "</wpml:actionTrigger>\n"
      "<wpml:action>\n"
      "<wpml:actionId>0</wpml:actionId>\n"
      "<wpml:actionActuatorFunc>gimbalRotate</wpml:actionActuatorFunc>\n"
      "<wpml:actionActuatorFuncParam>\n"
      "<wpml:payloadPositionIndex>0</wpml:payloadPositionIndex>\n"
      "<wpml:gimbalHeadingYawBase>north</wpml:gimbalHeadingYawBase>\n"
      "<wpml:gimbalRotateMode>absoluteAngle</wpml:gimbalRotateMode>\n"
      "<wpml:gimbalPitchRotateEnable>1</wpml:gimbalPitchRotateEnable>\n"
      "<wpml:gimbalPitchRotateAngle>{}</wpml:gimbalPitchRotateAngle>\n"
      "<wpml:gimbalRollRotateEnable>0</wpml:gimbalRollRotateEnable>\n"
      "<wpml:gimbalRollRotateAngle>0</wpml:gimbalRollRotateAngle>\n"
      "<wpml:gimbalYawRotateEnable>0</wpml:gimbalYawRotateEnable>\n"
      "<wpml:gimbalYawRotateAngle>0</wpml:gimbalYawRotateAngle>\n"
      "<wpml:gimbalRotateTimeEnable>0</wpml:gimbalRotateTimeEnable>\n"
      "<wpml:gimbalRotateTime>0</wpml:gimbalRotateTime>\n"
      "</wpml:actionActuatorFuncParam>\n"
      "</wpml:action>\n"
      "</wpml:actionGroup>\n",
      shortest(*mission.gimbal));
}

std::string point(const DjiWaypoint& waypoint, std::size_t index) {
  return fmt::format(
      "<Placemark>\n"
      "<Point><coordinates>{:.9f},{:.9f}</coordinates></Point>\n"
      "<wpml:index>{}</wpml:index>\n",
      waypoint.longitude, waypoint.latitude, index);
}

std::string turn(const DjiWaypoint& waypoint) {
  return fmt::format(
      "<wpml:waypointTurnParam>\n"
      "<wpml:waypointTurnMode>{}</wpml:waypointTurnMode>\n"
      "<wpml:waypointTurnDampingDist>{}</wpml:waypointTurnDampingDist>\n"
      "</wpml:waypointTurnParam>\n"
      "<wpml:useStraightLine>1</wpml:useStraightLine>\n",
      name_of(waypoint.turn), shortest(waypoint.damping));
}

std::string waylines(const DjiMission& mission) {
  const DjiWayline& wayline = mission.waylines.front();
  std::string text = head(mission) + config(mission);
  text += fmt::format(
      "<Folder>\n"
      "<wpml:templateId>0</wpml:templateId>\n"
      "<wpml:executeHeightMode>relativeToStartPoint</wpml:executeHeightMode>\n"
      "<wpml:waylineId>0</wpml:waylineId>\n"
      "<wpml:autoFlightSpeed>{}</wpml:autoFlightSpeed>\n",
      shortest(mission.transit_speed));
  for (std::size_t i = 0; i < wayline.waypoints.size(); ++i) {
    const DjiWaypoint& w = wayline.waypoints[i];
    text += point(w, i);
    text += fmt::format(
        "<wpml:executeHeight>{:.3f}</wpml:executeHeight>\n"
        "<wpml:waypointSpeed>{}</wpml:waypointSpeed>\n"
        "<wpml:waypointHeadingParam>\n"
        "{}"
        "</wpml:waypointHeadingParam>\n",
        w.height, shortest(w.speed), heading(mission));
    text += turn(w);
    text += gimbal(mission, i);
    text += "</Placemark>\n";
  }
  return text + "</Folder>\n</Document>\n</kml>\n";
}

std::string template_of(const DjiMission& mission, std::string_view author) {
  const DjiWayline& wayline = mission.waylines.front();
  std::string text = head(mission);
  text += fmt::format("<wpml:author>{}</wpml:author>\n", geom::escaped_markup(author));
  text += config(mission);
  text += fmt::format(
      "<Folder>\n"
      "<wpml:templateType>waypoint</wpml:templateType>\n"
      "<wpml:templateId>0</wpml:templateId>\n"
      "<wpml:waylineCoordinateSysParam>\n"
      "<wpml:coordinateMode>WGS84</wpml:coordinateMode>\n"
      "<wpml:heightMode>relativeToStartPoint</wpml:heightMode>\n"
      "</wpml:waylineCoordinateSysParam>\n"
      "<wpml:autoFlightSpeed>{}</wpml:autoFlightSpeed>\n"
      "<wpml:globalHeight>{:.3f}</wpml:globalHeight>\n"
      "<wpml:caliFlightEnable>0</wpml:caliFlightEnable>\n"
      "<wpml:gimbalPitchMode>manual</wpml:gimbalPitchMode>\n"
      "<wpml:globalWaypointHeadingParam>\n"
      "{}"
      "</wpml:globalWaypointHeadingParam>\n"
      "<wpml:globalWaypointTurnMode>toPointAndStopWithDiscontinuityCurvature"
      "</wpml:globalWaypointTurnMode>\n"
      "<wpml:globalUseStraightLine>1</wpml:globalUseStraightLine>\n",
      shortest(mission.transit_speed), wayline.waypoints.front().height, heading(mission));
  for (std::size_t i = 0; i < wayline.waypoints.size(); ++i) {
    const DjiWaypoint& w = wayline.waypoints[i];
    text += point(w, i);
    text += fmt::format(
        "<wpml:ellipsoidHeight>{:.3f}</wpml:ellipsoidHeight>\n"
        "<wpml:height>{:.3f}</wpml:height>\n"
        "<wpml:useGlobalHeight>0</wpml:useGlobalHeight>\n"
        "<wpml:useGlobalSpeed>1</wpml:useGlobalSpeed>\n"
        "<wpml:useGlobalHeadingParam>1</wpml:useGlobalHeadingParam>\n"
        "<wpml:useGlobalTurnParam>{}</wpml:useGlobalTurnParam>\n",
        mission.takeoff->height + w.height, w.height, w.turn == DjiTurn::stop ? 1 : 0);
    if (w.turn != DjiTurn::stop) text += turn(w);
    text += gimbal(mission, i);
    text += "</Placemark>\n";
  }
  return text + "</Folder>\n</Document>\n</kml>\n";
}

}  // namespace

void write_dji_kmz(std::ostream& out, const DjiMission& mission, std::string_view author) {
  const std::array<geom::SmallFile, 2> files = {
      {{kTemplate, template_of(mission, author)}, {kWaylines, waylines(mission)}}};
  geom::write_small_zip(out, files);
}

DjiMission read_dji_kmz(std::istream& in, std::string_view source) {
  const std::string archive(std::istreambuf_iterator<char>(in), {});
  const std::string name(source);
  const auto files = geom::files_of_zip(
      archive, name, {"a mission of DJI (.kmz)", {kWaylines, kTemplate}, {".wpml", ".kml"}});
  if (files.empty() || files.front().name != kWaylines) {
    throw geom::InputError(
        name,
        {.expected = fmt::format("{}, which a DJI aircraft flies", kWaylines), .found = "none"});
  }
  return read_dji_wpml(files.front().content, files.size() > 1 ? files[1].content : "", source);
}

DjiMission read_dji_wpml(std::string_view waylines, std::string_view template_kml,
                         std::string_view source) {
  const std::string flown_source = fmt::format("{}/{}", source, kWaylines);
  DjiMission mission = read_dji_waylines(parse_xml(waylines, flown_source), flown_source);
  if (template_kml.empty()) return mission;
  const std::string template_source = fmt::format("{}/{}", source, kTemplate);
  hold_against_template(parse_xml(template_kml, template_source), template_source, mission);
  return mission;
}

}  // namespace traj
