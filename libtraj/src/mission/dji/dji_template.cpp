#include "dji_template.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dji_waylines.h"
#include "geom/base/error.h"
#include "wpml_fields.h"

namespace traj {
namespace {

constexpr double kSameDegrees = 1e-7;
constexpr double kSameMetres = 0.01;
constexpr double kFarthestHeight = 1e5;

const char* name_of(DjiFinish finish) {
  switch (finish) {
    case DjiFinish::go_home:
      return "goHome";
    case DjiFinish::hover:
      return "noAction";
    case DjiFinish::land:
      return "autoLand";
    case DjiFinish::first_waypoint:
      return "gotoFirstWaypoint";
  }
  return "";
}

class TemplateReader {
 public:
  TemplateReader(const std::string& source, DjiMission& mission)
      : source_(source), mission_(mission) {}

  void hold(const XmlElement& root) {
    wpml_version(root, source_);
    const WpmlFields kml(root, source_, {{"Document"}});
    const WpmlFields document(kml.child("Document"), source_,
                              {{"wpml:missionConfig"}, {"Folder"}, true});
    if (const XmlElement* config = document.find("wpml:missionConfig")) hold_config(*config);
    for (const XmlElement* folder : document.all("Folder")) hold_folder(*folder);
  }

 private:
  [[noreturn]] void differ(const XmlElement& at, const std::string& what) const {
    throw geom::InputError(
        source_, at.line,
        {.says = fmt::format("{} than in waylines.wpml, which the aircraft flies", what),
         .advice = "an app that opens the mission may replace it; save it in that app again"});
  }

  void hold_config(const XmlElement& element) {
    const WpmlFields config(
        element, source_,
        {{"wpml:flyToWaylineMode", "wpml:finishAction", "wpml:takeOffSecurityHeight",
          "wpml:globalRTHHeight", "wpml:takeOffRefPoint"},
         {},
         true});
    const bool safely = mission_.approach == DjiApproach::safely;
    hold_word(config, "wpml:flyToWaylineMode", safely ? "safely" : "pointToPoint");
    hold_word(config, "wpml:finishAction", name_of(mission_.finish));
    hold_metres(config, "wpml:takeOffSecurityHeight", mission_.security_height);
    if (mission_.return_height) {
      hold_metres(config, "wpml:globalRTHHeight", *mission_.return_height);
    }
    const auto takeoff = planned_takeoff(element, source_);
    if (!takeoff) return;
    if (mission_.takeoff && *mission_.takeoff != *takeoff) {
      differ(config.child("wpml:takeOffRefPoint"), "<wpml:takeOffRefPoint> is another");
    }
    mission_.takeoff = takeoff;
  }

  void hold_word(const WpmlFields& fields, const char* name, const std::string& word) const {
    if (fields.find(name) && fields.text(name) != word) {
      differ(fields.child(name), fmt::format("<{}> is another", name));
    }
  }

  void hold_metres(const WpmlFields& fields, const char* name, double height) const {
    if (!fields.find(name)) return;
    const double said = fields.number(name, -kFarthestHeight, kFarthestHeight);
    if (std::abs(said - height) > kSameMetres) {
      differ(fields.child(name), fmt::format("<{}> is another", name));
    }
  }

  void hold_folder(const XmlElement& element) const {
    const WpmlFields folder(
        element, source_,
        {{"wpml:templateType", "wpml:templateId", "wpml:caliFlightEnable",
          "wpml:waylineCoordinateSysParam", "wpml:globalHeight", "wpml:globalWaypointTurnMode"},
         {"Placemark"},
         true});
    if (folder.find("wpml:caliFlightEnable") &&
        folder.word("wpml:caliFlightEnable", {"0", "1"}) == "1") {
      folder.refuse(folder.child("wpml:caliFlightEnable"),
                    {.says = "<wpml:caliFlightEnable> must be 0",
                     .found = "1",
                     .advice = "the aircraft would fly to and fro to calibrate its lidar"});
    }
    if (!folder.find("wpml:templateType") || folder.text("wpml:templateType") != "waypoint") return;
    const int id = folder.whole("wpml:templateId");
    const auto placemarks = folder.all("Placemark");
    const auto made_of_it = [&](const DjiWayline& wayline) { return wayline.template_id == id; };
    const auto wayline =
        std::find_if(mission_.waylines.begin(), mission_.waylines.end(), made_of_it);
    if (wayline == mission_.waylines.end() || wayline->waypoints.size() != placemarks.size()) {
      differ(element, "this template has other waypoints");
    }
    hold_height_mode(folder, *wayline);
    for (std::size_t i = 0; i < placemarks.size(); ++i) {
      hold_waypoint(folder, *placemarks[i], *wayline, wayline->waypoints[i]);
    }
  }

  void hold_waypoint(const WpmlFields& folder, const XmlElement& element, const DjiWayline& wayline,
                     const DjiWaypoint& flown) const {
    const WpmlFields placemark(
        element, source_,
        {{"Point", "wpml:height", "wpml:ellipsoidHeight", "wpml:useGlobalHeight",
          "wpml:useGlobalTurnParam", "wpml:waypointTurnParam"},
         {},
         true});
    DjiWaypoint said;
    read_wpml_point(placemark.child("Point"), source_, said);
    if (std::abs(said.latitude - flown.latitude) > kSameDegrees ||
        std::abs(said.longitude - flown.longitude) > kSameDegrees) {
      differ(element, "this waypoint is elsewhere");
    }
    hold_waypoint_height(folder, placemark, wayline, flown);
    const bool own = placemark.find("wpml:useGlobalTurnParam") &&
                     placemark.word("wpml:useGlobalTurnParam", {"0", "1"}) == "0";
    if (!own) return hold_word(folder, "wpml:globalWaypointTurnMode", name_of(flown.turn));
    const WpmlFields turn(placemark.child("wpml:waypointTurnParam"), source_,
                          {{"wpml:waypointTurnMode", "wpml:waypointTurnDampingDist"}, {}, true});
    hold_word(turn, "wpml:waypointTurnMode", name_of(flown.turn));
    if (flown.turn != DjiTurn::stop) {
      hold_metres(turn, "wpml:waypointTurnDampingDist", flown.damping);
    }
  }

  // Heights above the ground may be waylines of either kind.
  void hold_height_mode(const WpmlFields& folder, const DjiWayline& wayline) const {
    const WpmlFields system(folder.child("wpml:waylineCoordinateSysParam"), source_,
                            {{"wpml:heightMode"}, {}, true});
    const std::string mode =
        system.word("wpml:heightMode",
                    {"EGM96", "relativeToStartPoint", "aboveGroundLevel", "realTimeFollowSurface"});
    if (mode == "aboveGroundLevel") return;
    const bool follows = wayline.heights == DjiHeights::above_surface;
    if ((mode == "realTimeFollowSurface") == follows) return;
    differ(system.child("wpml:heightMode"), "<wpml:heightMode> is another");
  }

  // Where both count from the same zero.
  void hold_waypoint_height(const WpmlFields& folder, const WpmlFields& placemark,
                            const DjiWayline& wayline, const DjiWaypoint& flown) const {
    if (wayline.heights == DjiHeights::above_surface) return;
    if (wayline.heights == DjiHeights::ellipsoid) {
      return hold_metres(placemark, "wpml:ellipsoidHeight", flown.height);
    }
    const WpmlFields system(folder.child("wpml:waylineCoordinateSysParam"), source_,
                            {{"wpml:heightMode"}, {}, true});
    if (system.text("wpml:heightMode") != "relativeToStartPoint") return;
    const bool global = placemark.find("wpml:useGlobalHeight") &&
                        placemark.word("wpml:useGlobalHeight", {"0", "1"}) == "1";
    global ? hold_metres(folder, "wpml:globalHeight", flown.height)
           : hold_metres(placemark, "wpml:height", flown.height);
  }

  const std::string& source_;
  DjiMission& mission_;
};

}  // namespace

void hold_against_template(const XmlElement& root, const std::string& source, DjiMission& mission) {
  TemplateReader(source, mission).hold(root);
}

}  // namespace traj
