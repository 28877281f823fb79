#include "traj/mission/formats/qgc_plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <istream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <ostream>

#include "geom/base/error.h"
#include "geom/base/text_stream.h"
#include "geom/text/beginning.h"
#include "geom/text/counted.h"
#include "geom/text/parse_json.h"
#include "mission/formats/mavlink_format.h"
#include "mission/formats/text_head.h"
#include "traj/mission/formats/mission_formats.h"

namespace traj {
namespace {

using Json = nlohmann::ordered_json;
using geom::shown;

constexpr int kGenericFirmware = 0;  // MAV_AUTOPILOT_GENERIC
constexpr int kGeneric = 0;          // MAV_TYPE_GENERIC
constexpr int kQuadrotor = 2;        // MAV_TYPE_QUADROTOR
constexpr int kAboveHome = 1;        // AltitudeMode
constexpr int kAboveSea = 2;
constexpr int kFromTerrain = 3;   // above the sea, worked out from a height above terrain
constexpr int kAboveTerrain = 4;  // the vehicle follows the terrain
// MAV_TYPE of what flies straight legs and rests in the air: rotors of all kinds.
constexpr int kRotorcraft[] = {kGeneric, kQuadrotor, 3, 4, 13, 14, 15, 29, 35};
constexpr double kSpeedForTimes = 5;  // m/s
const std::initializer_list<std::string_view> kPlanKeys = {
    "fileType", "geoFence", "groundStation", "mission", "rallyPoints", "version"};

Json item_json(const MissionItem& item, std::size_t number) {
  Json json;
  const bool placed = item.frame != kMissionFrame;
  if (placed) {
    json["AMSLAltAboveTerrain"] = nullptr;
    json["Altitude"] = item.altitude;
    json["AltitudeMode"] = 1;
  }
  json["autoContinue"] = true;
  json["command"] = item.command;
  json["doJumpId"] = number;
  json["frame"] = item.frame;
  Json params = Json::array();
  for (const double p : item.param) params.push_back(p);
  if (placed) params[3] = nullptr;  // the yaw is the vehicle's affair
  for (const double p : {item.latitude, item.longitude, item.altitude}) params.push_back(p);
  json["params"] = params;
  json["type"] = "SimpleItem";
  return json;
}

// [latitude, longitude]
Json corner_json(const geom::GeodeticPlace& place) {
  return Json::array({place.latitude, place.longitude});
}

Json fences_json(const Mission& mission) {
  Json circles = Json::array();
  Json polygons = Json::array();
  for (const GeodeticFence& fence : mission.fences) {
    if (fence.ring.empty()) {
      circles.push_back(
          {{"circle", {{"center", corner_json(fence.centre)}, {"radius", fence.radius}}},
           {"inclusion", fence.inclusion},
           {"version", 1}});
      continue;
    }
    Json ring = Json::array();
    for (const geom::GeodeticPlace& place : fence.ring) ring.push_back(corner_json(place));
    polygons.push_back({{"inclusion", fence.inclusion}, {"polygon", ring}, {"version", 1}});
  }
  return {{"circles", circles}, {"polygons", polygons}, {"version", 2}};
}

Json rally_json(const Mission& mission) {
  Json points = Json::array();
  for (const geom::GeodeticPlace& place : mission.rally) {
    points.push_back(Json::array({place.latitude, place.longitude, place.height}));
  }
  return {{"points", points}, {"version", 2}};
}

struct PlanReader {
  std::string_view source;

  [[noreturn]] void refuse(geom::Fault fault) const {
    throw geom::InputError(source, std::move(fault));
  }

  const Json& member(const Json& object, const char* key, const std::string& where) const {
    const auto it = object.find(key);
    if (it == object.end())
      refuse({.expected = fmt::format("the key {}.{}", where, key), .found = "none"});
    return *it;
  }

  // What is not known may be a fence, by another name or of another version.
  void require_known(const Json& parent, std::initializer_list<std::string_view> known,
                     const std::string& where) const {
    for (const auto& [key, value] : parent.items()) {
      if (std::find(known.begin(), known.end(), key) != known.end()) continue;
      refuse({.expected = fmt::format("no other keys in {} than {}", where, fmt::join(known, ", ")),
              .found = geom::in_quotes(key.substr(0, 40))});
    }
  }

  const Json& object(const Json& parent, const char* key, const std::string& where) const {
    const Json& value = member(parent, key, where);
    if (!value.is_object()) {
      refuse({.key = fmt::format("{}.{}", where, key),
              .expected = "an object",
              .found = shown(value)});
    }
    return value;
  }

  void require(const Json& parent, const char* key, const Json& wanted,
               const std::string& where) const {
    const Json& value = member(parent, key, where);
    if (value != wanted) {
      refuse({.key = fmt::format("{}.{}", where, key),
              .expected = wanted.dump(),
              .found = shown(value)});
    }
  }

  double number(const Json& value, const std::string& what) const {
    if (!value.is_number() || !std::isfinite(value.get<double>())) {
      refuse({.key = what, .expected = "a finite number", .found = shown(value)});
    }
    return value.get<double>();
  }

  int whole(const Json& parent, const char* key, const std::string& where) const {
    const double value = number(member(parent, key, where), where + '.' + key);
    if (value != std::floor(value) || value < 0 || value > 65535) {
      refuse({.key = fmt::format("{}.{}", where, key),
              .expected = "a whole number from 0 to 65535",
              .found = fmt::to_string(value)});
    }
    return static_cast<int>(value);
  }

  MissionItem item(const Json& json, const std::string& where, std::size_t index) const {
    if (!json.is_object()) refuse({.key = where, .expected = "an object", .found = shown(json)});
    require(json, "type", "SimpleItem", where);
    MissionItem item;
    item.number = json.contains("doJumpId")
                      ? static_cast<std::size_t>(whole(json, "doJumpId", where))
                      : index + 1;
    item.frame = whole(json, "frame", where);
    item.command = whole(json, "command", where);
    const Json& params = member(json, "params", where);
    if (!params.is_array() || params.size() != 7) {
      refuse({.key = fmt::format("{}.params", where),
              .expected = "a list of 7",
              .found = shown(params)});
    }
    const auto param = [&](std::size_t i) {
      if (params[i].is_null()) return std::numeric_limits<double>::quiet_NaN();
      return number(params[i], fmt::format("{}.params[{}]", where, i));
    };
    for (std::size_t i = 0; i < 4; ++i) item.param[i] = param(i);
    item.latitude = param(4);
    item.longitude = param(5);
    item.altitude = param(6);
    item.goes_on = goes_on(json, where);
    require_one_height(json, item, where);
    return item;
  }

  bool goes_on(const Json& json, const std::string& where) const {
    if (!json.contains("autoContinue")) return true;
    const Json& value = json["autoContinue"];
    if (value == true || value == 1) return true;
    if (value == false || value == 0) return false;
    refuse({.key = fmt::format("{}.autoContinue", where),
            .expected = "true or false",
            .found = shown(value)});
  }

  // What the file says of an item's height beside its frame and seventh parameter: QGroundControl
  // goes by this, other programs by those.
  void require_one_height(const Json& json, const MissionItem& item,
                          const std::string& where) const {
    if (item.frame == kMissionFrame) return;
    const auto said = [&](const char* key) { return json.contains(key) && !json[key].is_null(); };
    const int mode = said("AltitudeMode") ? whole(json, "AltitudeMode", where) : -1;
    if (mode > 0 && !fits(mode, item.frame)) {
      refuse({.key = fmt::format("{}.AltitudeMode", where),
              .expected = fmt::format("1, 2, 3 or 4 (above home, sea level, by way of the terrain, "
                                      "above it) as its frame {} says",
                                      item.frame),
              .found = fmt::to_string(mode)});
    }
    const char* key = mode == kFromTerrain ? "AMSLAltAboveTerrain" : "Altitude";
    if (!said(key)) return;
    const double height = number(json[key], fmt::format("{}.{}", where, key));
    if (std::abs(height - item.altitude) > 1e-3) {
      refuse({.key = fmt::format("{}.{}", where, key),
              .expected = fmt::format("the height in params, {}", item.altitude),
              .found = fmt::to_string(height)});
    }
  }

  static bool fits(int mode, int frame) {
    switch (frame) {
      case kGlobalRelative:
      case kGlobalRelativeInt:
        return mode == kAboveHome;
      case kGlobalTerrain:
      case kGlobalTerrainInt:
        return mode == kAboveTerrain;
      default:
        return mode == kAboveSea || mode == kFromTerrain;
    }
  }

  geom::GeodeticPlace place(const Json& value, const std::string& where, std::size_t size) const {
    if (!value.is_array() || value.size() != size) {
      refuse({.key = where,
              .expected = fmt::format("a list of {} numbers", size),
              .found = shown(value)});
    }
    const auto part = [&](std::size_t i) {
      return i < size ? number(value[i], fmt::format("{}[{}]", where, i)) : 0;
    };
    return {part(0), part(1), part(2)};
  }

  const Json& list(const Json& parent, const char* key, const std::string& where) const {
    const Json& value = member(parent, key, where);
    if (!value.is_array()) {
      refuse(
          {.key = fmt::format("{}.{}", where, key), .expected = "a list", .found = shown(value)});
    }
    return value;
  }

  bool inclusion(const Json& fence, const std::string& where) const {
    const Json& value = member(fence, "inclusion", where);
    if (value.is_boolean()) return value.get<bool>();
    refuse({.key = fmt::format("{}.inclusion", where),
            .expected = "true or false",
            .found = shown(value)});
  }

  std::vector<GeodeticFence> fences(const Json& plan) const {
    std::vector<GeodeticFence> fences;
    if (!plan.contains("geoFence")) return fences;
    const Json& fence = object(plan, "geoFence", "plan");
    require_known(fence, {"breachReturn", "circles", "polygons", "version"}, "geoFence");
    if (!fence.empty()) require(fence, "version", 2, "geoFence");
    const auto each = [&](const char* key, const auto& take) {
      if (!fence.contains(key)) return;
      const Json& all = list(fence, key, "geoFence");
      for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string where = fmt::format("geoFence.{}[{}]", key, i);
        if (!all[i].is_object()) {
          refuse({.key = where, .expected = "an object", .found = shown(all[i])});
        }
        fences.push_back({inclusion(all[i], where), {}, {}, 0});
        take(all[i], where, fences.back());
      }
    };
    each("circles", [&](const Json& json, const std::string& where, GeodeticFence& out) {
      const Json& circle = object(json, "circle", where);
      out.centre = place(member(circle, "center", where), where + ".circle.center", 2);
      out.radius = number(member(circle, "radius", where), where + ".circle.radius");
    });
    each("polygons", [&](const Json& json, const std::string& where, GeodeticFence& out) {
      for (const Json& corner : list(json, "polygon", where)) {
        out.ring.push_back(place(corner, where + ".polygon[]", 2));
      }
      if (out.ring.empty())
        refuse({.says = fmt::format("{}.polygon must have corners", where), .found = "none"});
    });
    return fences;
  }

  std::vector<geom::GeodeticPlace> rally(const Json& plan) const {
    std::vector<geom::GeodeticPlace> places;
    if (!plan.contains("rallyPoints")) return places;
    const Json& points = object(plan, "rallyPoints", "plan");
    require_known(points, {"points", "version"}, "rallyPoints");
    if (!points.contains("points")) return places;
    for (const Json& point : list(points, "points", "rallyPoints")) {
      places.push_back(place(point, "rallyPoints.points[]", 3));
    }
    return places;
  }

  void require_rotorcraft(const Json& mission) const {
    if (!mission.contains("vehicleType")) return;
    const int type = whole(mission, "vehicleType", "mission");
    if (std::find(std::begin(kRotorcraft), std::end(kRotorcraft), type) != std::end(kRotorcraft)) {
      return;
    }
    refuse({.key = "mission.vehicleType",
            .expected = "one that flies straight legs and hovers (2, a quadrotor, or its like)",
            .found = fmt::to_string(type)});
  }

  // A survey and its like hold the items that QGroundControl made of them.
  void add_items(const Json& items, const std::string& where, Mission& mission) const {
    for (std::size_t i = 0; i < items.size(); ++i) {
      const std::string here = fmt::format("{}[{}]", where, i);
      const Json& json = items[i];
      const bool complex = json.is_object() && json.contains("type") &&
                           json["type"] == "ComplexItem" &&
                           json.contains("TransectStyleComplexItem");
      if (!complex) {
        mission.items.push_back(item(json, here, mission.items.size()));
        continue;
      }
      const Json& transects = object(json, "TransectStyleComplexItem", here);
      if (list(transects, "Items", here + ".TransectStyleComplexItem").empty()) {
        refuse({.says = fmt::format("{}.TransectStyleComplexItem.Items must hold the items that "
                                    "QGroundControl makes of it",
                                    here),
                .found = "none",
                .advice = "open the plan there and save it again"});
      }
      add_items(list(transects, "Items", here + ".TransectStyleComplexItem"),
                here + ".TransectStyleComplexItem.Items", mission);
    }
  }

  // The members that may hold places, or the unknown ones that hold none (one word or number, such
  // as a UUID).
  static Json pick(const Json& plan, bool places) {
    Json out = Json::object();
    for (const auto& [key, value] : plan.items()) {
      const bool known = std::find(kPlanKeys.begin(), kPlanKeys.end(), key) != kPlanKeys.end();
      if ((known || value.is_structured()) == places) out[key] = value;
    }
    return out;
  }

  Json plan(std::istream& in) const {
    const std::string text(std::istreambuf_iterator<char>(in), {});
    Json plan = geom::parse_ordered_json(text, source);
    if (!plan.is_object()) refuse({.expected = "a JSON object", .found = shown(plan)});
    require(plan, "fileType", "Plan", "plan");
    require(plan, "version", 1, "plan");
    require_known(pick(plan, true), kPlanKeys, "plan");
    return plan;
  }

  // QGroundControl works these out anew when it opens the plan.
  static void note_heights(const Json& items, Mission& mission) {
    const auto count =
        static_cast<std::size_t>(std::count_if(items.begin(), items.end(), [](const Json& item) {
          return item.contains("AltitudeMode") && item["AltitudeMode"] == kFromTerrain;
        }));
    if (count == 0) return;
    mission.notes.push_back(fmt::format(
        "QGroundControl worked out {} from its terrain (AltitudeMode 3), and does so anew when it "
        "opens the plan: what was looked at are the heights in the file",
        geom::counted(count, "height")));
  }

  Mission mission(const Json& plan) const {
    const Json& json = object(plan, "mission", "plan");
    require(json, "version", 2, "mission");
    require_rotorcraft(json);
    Mission mission;
    const Json passed_over = pick(plan, false);
    for (const auto& [key, value] : passed_over.items()) {
      mission.notes.push_back(fmt::format("its member \"{}\" is not known here, and is passed over",
                                          key.substr(0, 40)));
    }
    mission.home =
        place(member(json, "plannedHomePosition", "mission"), "mission.plannedHomePosition", 3);
    mission.fences = fences(plan);
    mission.rally = rally(plan);
    const Json& items = member(json, "items", "mission");
    if (!items.is_array() || items.empty()) {
      refuse({.key = "mission.items", .expected = "a list of at least one", .found = shown(items)});
    }
    add_items(items, "mission.items", mission);
    note_heights(items, mission);
    return mission;
  }
};

}  // namespace

void write_qgc_plan(std::ostream& out, const Mission& mission, std::string_view station) {
  double speed = kSpeedForTimes;
  Json items = Json::array();
  for (const MissionItem& item : mission.items) {
    if (item.command == kSpeed) speed = item.param[1];
    items.push_back(item_json(item, items.size() + 1));
  }
  const geom::GeodeticPlace home = mission.home.value_or(geom::GeodeticPlace{});
  const Json plan = {{"fileType", "Plan"},
                     {"geoFence", fences_json(mission)},
                     {"groundStation", std::string(station)},
                     {"mission",
                      {{"cruiseSpeed", speed},
                       {"firmwareType", kGenericFirmware},
                       {"globalPlanAltitudeMode", 1},
                       {"hoverSpeed", speed},
                       {"items", items},
                       {"plannedHomePosition", {home.latitude, home.longitude, home.height}},
                       {"vehicleType", kQuadrotor},
                       {"version", 2}}},
                     {"rallyPoints", rally_json(mission)},
                     {"version", 1}};
  out << plan.dump(1) << '\n';
}

Mission read_qgc_plan(std::istream& in, std::string_view source) {
  const PlanReader reader{source};
  return reader.mission(reader.plan(in));
}

std::vector<GeodeticFence> read_qgc_fences(std::istream& in, std::string_view source) {
  const PlanReader reader{source};
  return reader.fences(reader.plan(in));
}

namespace {

WrittenMission write(const MissionTask& task, const geom::Polyline& legs) {
  return write_mission(task, legs, [](const Mission& mission, const MissionTask& of) {
    geom::TextOutput text;
    write_qgc_plan(text, mission, of.checked ? "skyway" : "skyway (UNCHECKED)");
    return WrittenMission{text.str()};
  });
}

}  // namespace

constinit const MissionFormat kQgcPlan = mavlink_format(
    {.word = "qgc-plan",
     .what = "a QGroundControl plan",
     .begins = geom::json_with<R"("fileType":"Plan")">,
     .readers = kDroneReaders},

    [](std::string_view text) {
      return text_head(text).starts_with("{") &&
             text.find("\"fileType\"") != std::string_view::npos;
    },
    [](std::istream& in, const ReadTask& task) {
      return fly_mission(read_qgc_plan(in, task.source), task);
    },
    write);

}  // namespace traj
