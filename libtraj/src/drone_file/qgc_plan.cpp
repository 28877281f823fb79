#include "traj/drone_file/qgc_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <istream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <ostream>

#include "geom/base/error.h"
#include "geom/text/parse_json.h"

namespace traj {
namespace {

using Json = nlohmann::ordered_json;
using geom::shown;

constexpr int kGenericFirmware = 0;  // MAV_AUTOPILOT_GENERIC
constexpr int kGeneric = 0;          // MAV_TYPE_GENERIC
constexpr int kQuadrotor = 2;        // MAV_TYPE_QUADROTOR
constexpr int kAboveHome = 1;        // AltitudeMode
constexpr int kAboveSea = 2;         // from 3 on, heights follow the terrain
// MAV_TYPE of what flies straight legs and rests in the air: rotors of all kinds.
constexpr int kRotorcraft[] = {kGeneric, kQuadrotor, 3, 4, 13, 14, 15, 29, 35};
constexpr double kUnsaidSpeed = 5;  // m/s

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

struct PlanReader {
  std::string_view source;

  [[noreturn]] void refuse(const std::string& message) const {
    throw geom::InputError(source, message);
  }

  const Json& member(const Json& object, const char* key, const std::string& where) const {
    const auto it = object.find(key);
    if (it == object.end()) refuse(fmt::format("expected the key {}.{}, found none", where, key));
    return *it;
  }

  const Json& object(const Json& parent, const char* key, const std::string& where) const {
    const Json& value = member(parent, key, where);
    if (!value.is_object()) {
      refuse(fmt::format("{}.{} must be an object, found {}", where, key, shown(value)));
    }
    return value;
  }

  void require(const Json& parent, const char* key, const Json& wanted,
               const std::string& where) const {
    const Json& value = member(parent, key, where);
    if (value != wanted) {
      refuse(fmt::format("{}.{} must be {}, found {}", where, key, wanted.dump(), shown(value)));
    }
  }

  double number(const Json& value, const std::string& what) const {
    if (!value.is_number() || !std::isfinite(value.get<double>())) {
      refuse(fmt::format("{} must be a finite number, found {}", what, shown(value)));
    }
    return value.get<double>();
  }

  int whole(const Json& parent, const char* key, const std::string& where) const {
    const double value = number(member(parent, key, where), where + '.' + key);
    if (value != std::floor(value) || value < 0 || value > 65535) {
      refuse(
          fmt::format("{}.{} must be a whole number from 0 to 65535, found {}", where, key, value));
    }
    return static_cast<int>(value);
  }

  MissionItem item(const Json& json, std::size_t index) const {
    const std::string where = fmt::format("mission.items[{}]", index);
    if (!json.is_object())
      refuse(fmt::format("{} must be an object, found {}", where, shown(json)));
    require(json, "type", "SimpleItem", where);
    MissionItem item;
    item.frame = whole(json, "frame", where);
    item.command = whole(json, "command", where);
    const Json& params = member(json, "params", where);
    if (!params.is_array() || params.size() != 7) {
      refuse(fmt::format("{}.params must be a list of 7, found {}", where, shown(params)));
    }
    const auto param = [&](std::size_t i) {
      if (params[i].is_null()) return std::numeric_limits<double>::quiet_NaN();
      return number(params[i], fmt::format("{}.params[{}]", where, i));
    };
    for (std::size_t i = 0; i < 4; ++i) item.param[i] = param(i);
    item.latitude = param(4);
    item.longitude = param(5);
    item.altitude = param(6);
    require_one_height(json, item, where);
    return item;
  }

  // What the file says of an item's height beside its frame and seventh parameter: QGroundControl
  // goes by this, other programs by those.
  void require_one_height(const Json& json, const MissionItem& item,
                          const std::string& where) const {
    const auto said = [&](const char* key) { return json.contains(key) && !json[key].is_null(); };
    if (said("AltitudeMode") && item.frame != kMissionFrame) {
      const int mode = whole(json, "AltitudeMode", where);
      const bool home = item.frame == kGlobalRelative || item.frame == kGlobalRelativeInt;
      if (mode != (home ? kAboveHome : kAboveSea)) {
        refuse(
            fmt::format("{}.AltitudeMode must be 1 or 2 (above home or sea level) as its frame "
                        "{} says, found {}",
                        where, item.frame, mode));
      }
    }
    if (said("Altitude") && item.frame != kMissionFrame) {
      const double height = number(json["Altitude"], where + ".Altitude");
      if (std::abs(height - item.altitude) > 1e-3) {
        refuse(fmt::format("{}.Altitude must be the height in params, {}, found {}", where,
                           item.altitude, height));
      }
    }
  }

  void require_no_fence(const Json& plan) const {
    if (!plan.contains("geoFence")) return;
    const Json& fence = object(plan, "geoFence", "plan");
    for (const char* key : {"circles", "polygons"}) {
      if (!fence.contains(key) || (fence[key].is_array() && fence[key].empty())) continue;
      refuse(
          fmt::format("plan.geoFence.{} must be empty, found {}: what a vehicle does at a fence "
                      "is not checked; remove it",
                      key, shown(fence[key])));
    }
  }

  void require_rotorcraft(const Json& mission) const {
    if (!mission.contains("vehicleType")) return;
    const int type = whole(mission, "vehicleType", "mission");
    if (std::find(std::begin(kRotorcraft), std::end(kRotorcraft), type) != std::end(kRotorcraft)) {
      return;
    }
    refuse(
        fmt::format("mission.vehicleType must be one that flies straight legs and hovers (2, a "
                    "quadrotor, or its like), found {}",
                    type));
  }

  geom::GeodeticPlace home(const Json& value) const {
    if (!value.is_array() || value.size() != 3) {
      refuse(fmt::format("mission.plannedHomePosition must be a list of 3 numbers, found {}",
                         shown(value)));
    }
    const auto part = [&](std::size_t i) {
      return number(value[i], fmt::format("mission.plannedHomePosition[{}]", i));
    };
    return {part(0), part(1), part(2)};
  }

  Mission mission(const Json& plan) const {
    require(plan, "fileType", "Plan", "plan");
    require(plan, "version", 1, "plan");
    const Json& json = object(plan, "mission", "plan");
    require(json, "version", 2, "mission");
    require_no_fence(plan);
    require_rotorcraft(json);
    Mission mission;
    mission.home = home(member(json, "plannedHomePosition", "mission"));
    const Json& items = member(json, "items", "mission");
    if (!items.is_array() || items.empty()) {
      refuse(fmt::format("mission.items must be a list of at least one, found {}", shown(items)));
    }
    for (std::size_t i = 0; i < items.size(); ++i) mission.items.push_back(item(items[i], i));
    return mission;
  }
};

}  // namespace

void write_qgc_plan(std::ostream& out, const Mission& mission, std::string_view station) {
  double speed = kUnsaidSpeed;
  Json items = Json::array();
  for (const MissionItem& item : mission.items) {
    if (item.command == kSpeed) speed = item.param[1];
    items.push_back(item_json(item, items.size() + 1));
  }
  const geom::GeodeticPlace home = mission.home.value_or(geom::GeodeticPlace{});
  const Json plan = {
      {"fileType", "Plan"},
      {"geoFence", {{"circles", Json::array()}, {"polygons", Json::array()}, {"version", 2}}},
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
      {"rallyPoints", {{"points", Json::array()}, {"version", 2}}},
      {"version", 1}};
  out << plan.dump(1) << '\n';
}

Mission read_qgc_plan(std::istream& in, std::string_view source) {
  const PlanReader reader{source};
  const std::string text(std::istreambuf_iterator<char>(in), {});
  const Json plan = geom::parse_ordered_json(text, source);
  if (!plan.is_object()) reader.refuse("expected a JSON object, found " + shown(plan));
  return reader.mission(plan);
}

}  // namespace traj
