#include "dji_waylines.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geom/base/error.h"
#include "geom/text/excerpt.h"
#include "wpml_fields.h"

namespace traj {
namespace {

constexpr std::string_view kKml = "http://www.opengis.net/kml/2.2";
constexpr std::string_view kWpmz = "http://www.dji.com/wpmz/";
// Of http://www.dji.com/wpmz/. They differ in the elements that they have; one that is read means
// the same in each, and others are refused.
constexpr std::array<std::string_view, 6> kVersions = {"1.0.0", "1.0.2", "1.0.3",
                                                       "1.0.4", "1.0.5", "1.0.6"};
constexpr std::string_view kVersionWords = "1.0.0 or 1.0.2 to 1.0.6";
constexpr double kFastest = 100;         // m/s
constexpr double kFarthestHeight = 1e5;  // m

// actionActuatorFunc of what changes no place and no height: cameras, gimbals, yaw, rest, lidars.
constexpr std::array<std::string_view, 14> kMovesNothing = {
    "takePhoto",     "startRecord",   "stopRecord",       "focus",   "zoom",
    "customDirName", "gimbalRotate",  "rotateYaw",        "hover",   "gimbalEvenlyRotate",
    "accurateShoot", "orientedShoot", "recordPointCloud", "panoShot"};

[[noreturn]] void refuse(const std::string& source, std::size_t line, geom::Fault fault) {
  throw geom::InputError(source, line, std::move(fault));
}

void require_no_namespaces(const XmlElement& element, const std::string& source) {
  for (const XmlElement& child : element.children) {
    for (const auto& [key, value] : child.attributes) {
      if (key.starts_with("xmlns")) {
        refuse(source, child.line, {.expected = "namespaces in <kml> alone", .found = "one"});
      }
    }
    require_no_namespaces(child, source);
  }
}

// The value of one attribute of the root.
std::string attribute(const XmlElement& root, std::string_view name, const std::string& source) {
  for (const auto& [key, value] : root.attributes) {
    if (key == name) return value;
  }
  refuse(source, root.line, {.expected = fmt::format("{} in <kml>", name), .found = "none"});
}

// Settings that may let the aircraft leave its way, where they are on.
void require_off(const WpmlFields& fields, std::string_view name) {
  if (!fields.find(name)) return;
  if (fields.word(name, {"0", "1"}) == "0") return;
  fields.refuse(fields.child(name), {.key = fmt::format("<{}>", name),
                                     .expected = "0",
                                     .found = "1",
                                     .advice = "the aircraft would leave its way as it sees fit"});
}

class WaylinesReader {
 public:
  WaylinesReader(const XmlElement& root, const std::string& source)
      : root_(root), source_(source) {}

  DjiMission read() {
    mission_.version = wpml_version(root_, source_);
    const WpmlFields kml(root_, source_, {{"Document"}});
    const WpmlFields document(
        kml.child("Document"), source_,
        {{"wpml:author", "wpml:createTime", "wpml:updateTime", "wpml:missionConfig"}, {"Folder"}});
    read_config(document.child("wpml:missionConfig"));
    for (const XmlElement* folder : document.all("Folder")) read_wayline(*folder);
    if (mission_.waylines.empty()) {
      refuse(source_, root_.line,
             {.expected = "at least one <Folder> of waypoints", .found = "none"});
    }
    return std::move(mission_);
  }

 private:
  void read_config(const XmlElement& element) {
    const WpmlFields config(
        element, source_,
        {{"wpml:flyToWaylineMode", "wpml:finishAction", "wpml:exitOnRCLost",
          "wpml:executeRCLostAction", "wpml:takeOffSecurityHeight", "wpml:takeOffRefPoint",
          "wpml:takeOffRefPointAGLHeight", "wpml:globalTransitionalSpeed", "wpml:globalRTHHeight",
          "wpml:droneInfo", "wpml:payloadInfo", "wpml:autoRerouteInfo",
          "wpml:waylineAvoidLimitAreaMode"}});
    const bool safely =
        config.word("wpml:flyToWaylineMode", {"safely", "pointToPoint"}) == "safely";
    mission_.approach = safely ? DjiApproach::safely : DjiApproach::point_to_point;
    read_finish(config);
    read_lost_link(config);
    mission_.security_height = config.number("wpml:takeOffSecurityHeight", 2, 1500);
    mission_.transit_speed =
        std::max(speed(config, "wpml:globalTransitionalSpeed"), kDjiSlowestTransit);
    if (config.find("wpml:globalRTHHeight")) {
      mission_.return_height = config.number("wpml:globalRTHHeight", 0, kFarthestHeight);
    }
    mission_.takeoff = planned_takeoff(element, source_);
    require_off(config, "wpml:waylineAvoidLimitAreaMode");
    if (const XmlElement* reroute = config.find("wpml:autoRerouteInfo")) {
      const WpmlFields modes(*reroute, source_,
                             {{"wpml:missionAutoRerouteMode", "wpml:transitionalAutoRerouteMode"}});
      require_off(modes, "wpml:missionAutoRerouteMode");
      require_off(modes, "wpml:transitionalAutoRerouteMode");
    }
    const WpmlFields drone(config.child("wpml:droneInfo"), source_,
                           {{"wpml:droneEnumValue", "wpml:droneSubEnumValue"}});
    mission_.aircraft.type = drone.whole("wpml:droneEnumValue");
    mission_.aircraft.kind =
        drone.find("wpml:droneSubEnumValue") ? drone.whole("wpml:droneSubEnumValue") : 0;
  }

  void read_finish(const WpmlFields& config) {
    const std::string finish =
        config.word("wpml:finishAction", {"goHome", "noAction", "autoLand", "gotoFirstWaypoint"});
    mission_.finish = finish == "goHome"     ? DjiFinish::go_home
                      : finish == "noAction" ? DjiFinish::hover
                      : finish == "autoLand" ? DjiFinish::land
                                             : DjiFinish::first_waypoint;
  }

  void read_lost_link(const WpmlFields& config) {
    mission_.without_link = config.word("wpml:exitOnRCLost", {"goContinue", "executeLostAction"});
    const bool said = config.find("wpml:executeRCLostAction");
    const bool used = mission_.without_link == "executeLostAction";
    if (!used && !said) return;
    const std::string action =
        config.word("wpml:executeRCLostAction", {"goBack", "landing", "hover"});
    if (used) mission_.without_link = action;
  }

  double speed(const WpmlFields& fields, std::string_view name) const {
    const double value = fields.number(name, 0, kFastest);
    if (value > 0) return value;
    fields.refuse(fields.child(name),
                  {.key = fmt::format("<{}>", name), .expected = "> 0 m/s", .found = "0"});
  }

  void read_wayline(const XmlElement& element) {
    const WpmlFields folder(
        element, source_,
        {{"wpml:templateId", "wpml:executeHeightMode", "wpml:waylineId", "wpml:distance",
          "wpml:duration", "wpml:autoFlightSpeed", "wpml:startActionGroup", "wpml:payloadParam",
          "wpml:realTimeFollowSurfaceByFov"},
         {"Placemark"}});
    const std::string heights = folder.word(
        "wpml:executeHeightMode", {"WGS84", "relativeToStartPoint", "realTimeFollowSurface"});
    const bool follows = heights == "realTimeFollowSurface";
    if (!follows) require_off(folder, "wpml:realTimeFollowSurfaceByFov");
    if (folder.find("wpml:waylineId")) {
      const int id = folder.whole("wpml:waylineId");
      if (id <= last_id_) {
        folder.refuse(
            folder.child("wpml:waylineId"),
            {.says = fmt::format("<wpml:waylineId> must be above {}, the one before", last_id_),
             .found = fmt::to_string(id)});
      }
      last_id_ = id;
    }
    DjiWayline wayline;
    wayline.template_id = folder.whole("wpml:templateId");
    wayline.heights = follows              ? DjiHeights::above_surface
                      : heights == "WGS84" ? DjiHeights::ellipsoid
                                           : DjiHeights::above_takeoff;
    const double usual = speed(folder, "wpml:autoFlightSpeed");
    if (const XmlElement* start = folder.find("wpml:startActionGroup")) {
      wayline.hover_before = take_actions(*start);
    }
    for (const XmlElement* placemark : folder.all("Placemark")) {
      const DjiWaypoint waypoint = read_waypoint(*placemark, usual, wayline.waypoints.size());
      wayline.waypoints.push_back(waypoint);
    }
    if (wayline.waypoints.empty()) {
      refuse(source_, element.line, {.expected = "waypoints in <Folder>", .found = "none"});
    }
    mission_.waylines.push_back(std::move(wayline));
  }

  DjiWaypoint read_waypoint(const XmlElement& element, double usual_speed, std::size_t index) {
    const WpmlFields placemark(
        element, source_,
        {{"Point", "wpml:index", "wpml:executeHeight", "wpml:waypointSpeed",
          "wpml:waypointHeadingParam", "wpml:waypointTurnParam", "wpml:useStraightLine",
          "wpml:waypointGimbalHeadingParam", "wpml:isRisky", "wpml:waypointWorkType"},
         {"wpml:actionGroup"}});
    if (static_cast<std::size_t>(placemark.whole("wpml:index")) != index) {
      placemark.refuse(placemark.child("wpml:index"),
                       {.says = fmt::format("<wpml:index> must be {}, the next", index),
                        .found = fmt::to_string(placemark.whole("wpml:index"))});
    }
    DjiWaypoint waypoint;
    waypoint.line = element.line;
    read_wpml_point(placemark.child("Point"), source_, waypoint);
    waypoint.height = placemark.number("wpml:executeHeight", -kFarthestHeight, kFarthestHeight);
    waypoint.speed = usual_speed;
    if (placemark.find("wpml:waypointSpeed")) {
      waypoint.speed = speed(placemark, "wpml:waypointSpeed");
    }
    read_turn(placemark, waypoint);
    if (placemark.find("wpml:waypointWorkType")) placemark.word("wpml:waypointWorkType", {"0"});
    for (const XmlElement* group : placemark.all("wpml:actionGroup")) {
      waypoint.hover += take_actions(*group);
    }
    return waypoint;
  }

  // Straight to the waypoint, and a stop or a turn there.
  void read_turn(const WpmlFields& placemark, DjiWaypoint& waypoint) const {
    const WpmlFields turn(placemark.child("wpml:waypointTurnParam"), source_,
                          {{"wpml:waypointTurnMode", "wpml:waypointTurnDampingDist"}});
    const bool straight = placemark.find("wpml:useStraightLine") &&
                          placemark.word("wpml:useStraightLine", {"0", "1"}) == "1";
    const std::string mode = turn.text("wpml:waypointTurnMode");
    if (mode == name_of(DjiTurn::early)) {
      waypoint.turn = DjiTurn::early;
    } else if (mode == name_of(DjiTurn::through) && straight) {
      waypoint.turn = DjiTurn::through;
    } else if (mode != name_of(DjiTurn::stop)) {
      turn.refuse(turn.child("wpml:waypointTurnMode"),
                  {.expected = fmt::format("straight legs with a stop or a turn at each waypoint "
                                           "({}, {}, or {} with <wpml:useStraightLine> 1)",
                                           name_of(DjiTurn::stop), name_of(DjiTurn::early),
                                           name_of(DjiTurn::through)),
                   .found = geom::in_quotes(geom::excerpt(mode))});
    }
    const bool stops = waypoint.turn == DjiTurn::stop;
    if (stops && !turn.find("wpml:waypointTurnDampingDist")) return;
    const double damping = turn.number("wpml:waypointTurnDampingDist", 0, kFarthestHeight);
    if (stops) return;
    waypoint.damping = damping;
    if (damping > 0) return;
    turn.refuse(
        turn.child("wpml:waypointTurnDampingDist"),
        {.says = "<wpml:waypointTurnDampingDist> must be > 0 m where the aircraft does not stop",
         .found = "0"});
  }

  // How long they let it hover in all, s.
  double take_actions(const XmlElement& element) {
    const WpmlFields group(
        element, source_,
        {{"wpml:actionGroupId", "wpml:actionGroupStartIndex", "wpml:actionGroupEndIndex",
          "wpml:actionGroupMode", "wpml:actionTrigger"},
         {"wpml:action"}});
    double hover = 0;
    for (const XmlElement* action : group.all("wpml:action")) hover += take_action(*action);
    return hover;
  }

  double take_action(const XmlElement& element) {
    const WpmlFields action(
        element, source_,
        {{"wpml:actionId", "wpml:actionActuatorFunc", "wpml:actionActuatorFuncParam"}});
    const std::string function = action.text("wpml:actionActuatorFunc");
    if (std::find(kMovesNothing.begin(), kMovesNothing.end(), function) == kMovesNothing.end()) {
      action.refuse(action.child("wpml:actionActuatorFunc"),
                    {.expected = "an action that is known to move the aircraft nowhere (of "
                                 "cameras, gimbals, yaw, rest)",
                     .found = geom::in_quotes(geom::excerpt(function))});
    }
    ++mission_.actions;
    if (function != "hover") return 0;
    const WpmlFields rest(action.child("wpml:actionActuatorFuncParam"), source_,
                          {{"wpml:hoverTime"}});
    return rest.number("wpml:hoverTime", 0, 1e6);
  }

  const XmlElement& root_;
  const std::string& source_;
  DjiMission mission_;
  int last_id_ = -1;  // of a wayline
};

}  // namespace

const char* name_of(DjiTurn turn) {
  switch (turn) {
    case DjiTurn::stop:
      return "toPointAndStopWithDiscontinuityCurvature";
    case DjiTurn::early:
      return "coordinateTurn";
    case DjiTurn::through:
      return "toPointAndPassWithContinuityCurvature";
  }
  return "";
}

std::string wpml_version(const XmlElement& root, const std::string& source) {
  if (wpml_name(root) != "kml") {
    refuse(
        source, root.line,
        {.expected = "WPML (<kml>)", .found = fmt::format("<{}>", geom::excerpt(wpml_name(root)))});
  }
  const std::string kml = attribute(root, "xmlns", source);
  const std::string wpml = attribute(root, "xmlns:wpml", source);
  if (kml != kKml) {
    refuse(source, root.line,
           {.expected = fmt::format("the namespace {}", kKml),
            .found = geom::in_quotes(geom::excerpt(kml))});
  }
  const std::string version = wpml.starts_with(kWpmz) ? wpml.substr(kWpmz.size()) : "";
  if (version.empty()) {
    refuse(source, root.line,
           {.expected = fmt::format("the namespace {}{}", kWpmz, kVersionWords),
            .found = geom::in_quotes(geom::excerpt(wpml))});
  }
  if (std::find(kVersions.begin(), kVersions.end(), version) == kVersions.end()) {
    refuse(source, root.line,
           {.expected = fmt::format("WPML of version {}", kVersionWords),
            .found = geom::excerpt(version)});
  }
  require_no_namespaces(root, source);
  return version;
}

std::optional<geom::GeodeticPlace> planned_takeoff(const XmlElement& config,
                                                   const std::string& source) {
  const WpmlFields fields(config, source, {{"wpml:takeOffRefPoint"}, {}, true});
  if (!fields.find("wpml:takeOffRefPoint")) return {};
  const std::string text = fields.text("wpml:takeOffRefPoint");
  const std::size_t one = text.find(',');
  const std::size_t two = one == text.npos ? one : text.find(',', one + 1);
  geom::GeodeticPlace place;
  const std::string_view view = text;
  if (two == text.npos || !read_wpml_number(view.substr(0, one), place.latitude) ||
      !read_wpml_number(view.substr(one + 1, two - one - 1), place.longitude) ||
      !read_wpml_number(view.substr(two + 1), place.height) || std::abs(place.latitude) > 90 ||
      std::abs(place.longitude) > 180 || std::abs(place.height) > kFarthestHeight) {
    fields.refuse(fields.child("wpml:takeOffRefPoint"),
                  {.says = "<wpml:takeOffRefPoint> must be latitude,longitude,height",
                   .found = geom::in_quotes(geom::excerpt(text))});
  }
  if (place == geom::GeodeticPlace{}) return {};  // apps write zeros where they have none
  return place;
}

void read_wpml_point(const XmlElement& point, const std::string& source, DjiWaypoint& waypoint) {
  const WpmlFields fields(point, source, {{"coordinates"}});
  const std::string text = fields.text("coordinates");
  const std::size_t comma = text.find(',');
  const std::string_view view = text;
  if (comma == text.npos || !read_wpml_number(view.substr(0, comma), waypoint.longitude) ||
      !read_wpml_number(view.substr(comma + 1), waypoint.latitude) ||
      std::abs(waypoint.longitude) > 180 || std::abs(waypoint.latitude) > 90) {
    fields.refuse(fields.child("coordinates"),
                  {.key = "<coordinates>",
                   .expected = "longitude,latitude within 180 and 90 degrees",
                   .found = geom::in_quotes(geom::excerpt(text))});
  }
}

DjiMission read_dji_waylines(const XmlElement& root, const std::string& source) {
  return WaylinesReader(root, source).read();
}

}  // namespace traj
