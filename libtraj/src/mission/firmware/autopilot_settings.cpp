#include "traj/mission/firmware/autopilot_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <istream>
#include <iterator>
#include <numbers>
#include <utility>

#include "geom/base/error.h"
#include "geom/text/excerpt.h"
#include "geom/text/text_table.h"
#include "set_fence.h"
#include "traj/mission/ulog/ulog_reader.h"

namespace traj {
namespace {

// One parameter: the field that it sets, SI of its unit, and the range that the firmware documents.
struct Parameter {
  const char* name;
  double Autopilot::*field;
  double unit;
  double least;
  double most;
};

constexpr Parameter kPx4[] = {
    {"NAV_ACC_RAD", &Autopilot::acceptance, 1, 0.05, 200},
    {"NAV_MC_ALT_RAD", &Autopilot::height_acceptance, 1, 0.05, 200},
    {"MPC_XY_CRUISE", &Autopilot::speed, 1, 0.1, 50},
    {"MPC_Z_V_AUTO_UP", &Autopilot::climb, 1, 0.1, 20},
    {"MPC_Z_V_AUTO_DN", &Autopilot::descent, 1, 0.1, 20},
    {"MPC_ACC_HOR", &Autopilot::acceleration, 1, 0.5, 50},
    {"MPC_JERK_AUTO", &Autopilot::jerk, 1, 0.5, 200},
    {"MIS_TAKEOFF_ALT", &Autopilot::takeoff_height, 1, 0, 80},
    {"RTL_RETURN_ALT", &Autopilot::return_height, 1, 0, 1000},
    {"RTL_MIN_DIST", &Autopilot::return_near, 1, 0.5, 10000},
    {"RTL_DESCEND_ALT", &Autopilot::return_descend, 1, 0, 1000},
};

// Copter 4.7 renamed these and counts in metres; up to 4.6 they are in centimetres.
constexpr Parameter kArdupilot[] = {
    {"WPNAV_RADIUS", &Autopilot::acceptance, 0.01, 5, 1000},
    {"WPNAV_SPEED", &Autopilot::speed, 0.01, 10, 5000},
    {"WPNAV_SPEED_UP", &Autopilot::climb, 0.01, 10, 2000},
    {"WPNAV_SPEED_DN", &Autopilot::descent, 0.01, 10, 2000},
    {"WPNAV_ACCEL", &Autopilot::acceleration, 0.01, 50, 2000},
    {"WPNAV_JERK", &Autopilot::jerk, 1, 0.5, 50},
    {"RTL_ALT", &Autopilot::return_height, 0.01, 0, 300000},
    {"RTL_CLIMB_MIN", &Autopilot::return_climb, 0.01, 0, 300000},
};
constexpr Parameter kArdupilotMetres[] = {
    {"WP_RADIUS_M", &Autopilot::acceptance, 1, 0.05, 10},
    {"WP_SPD", &Autopilot::speed, 1, 0.1, 50},
    {"WP_SPD_UP", &Autopilot::climb, 1, 0.1, 20},
    {"WP_SPD_DN", &Autopilot::descent, 1, 0.1, 20},
    {"WP_ACC", &Autopilot::acceleration, 1, 0.5, 20},
    {"WP_JERK", &Autopilot::jerk, 1, 0.5, 50},
    {"RTL_ALT_M", &Autopilot::return_height, 1, 0, 3000},
    {"RTL_CLIMB_MIN_M", &Autopilot::return_climb, 1, 0, 3000},
};
static_assert(std::size(kArdupilot) == std::size(kArdupilotMetres));
constexpr Parameter kArdupilotAlways[] = {
    {"RTL_CONE_SLOPE", &Autopilot::return_slope, 1, 0, 10},
    {"RALLY_LIMIT_KM", &Autopilot::rally_limit, 1000, 0, 1000},
};

// Names that vehicles of other classes have alone.
constexpr const char* kOtherVehicles[] = {
    "FW_AIRSPD_TRIM", "FW_AIRSPD_STALL", "AIRSPEED_CRUISE", "TRIM_ARSPD_CM",   "RTL_ALTITUDE",
    "ALT_HOLD_RTL",   "CRUISE_SPEED",    "CRUISE_THROTTLE", "JS_GAIN_DEFAULT", "RO_MAX_THR_SPEED"};

[[noreturn]] void refuse(std::string_view source, geom::Fault fault) {
  throw geom::InputError(source, std::move(fault));
}

// --- reading ----------------------------------------------------------------------------------

std::vector<std::string> words_of(std::string_view line) {
  std::vector<std::string> words(1);
  for (const char c : line) {
    if (c == ',' || c == '\t' || c == ' ') {
      if (!words.back().empty()) words.emplace_back();
    } else {
      words.back() += c;
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

void take_comment(std::string_view line, AutopilotSettings& out) {
  const std::size_t colon = line.find(':');
  if (colon == line.npos) return;
  const std::string_view key = geom::trimmed(line.substr(1, colon - 1));
  const std::string_view value = geom::trimmed(line.substr(colon + 1));
  if (key == "Vehicle") out.vehicle = value;
  if (key != "Version") return;
  const std::size_t end = value.find_first_not_of("0123456789.");
  const std::string_view digits = value.substr(0, end);
  out.version = digits.substr(0, digits.find('.', digits.find('.') + 1));
}

void take_value(const std::string& name, double value, std::string_view source, std::size_t line,
                AutopilotSettings& out) {
  if (!std::isfinite(value)) {
    throw geom::InputError(
        source, line, {.key = name, .expected = "a finite number", .found = fmt::to_string(value)});
  }
  const auto [found, fresh] = out.values.emplace(name, value);
  if (fresh || found->second == value) return;
  throw geom::InputError(source, line,
                         {.expected = fmt::format("one value of {}", name),
                          .found = fmt::format("{} after {}", value, found->second)});
}

void take_line(std::string_view line, std::string_view source, std::size_t number,
               AutopilotSettings& out) {
  const std::vector<std::string> words = words_of(line);
  const std::size_t name = words.size() == 5 ? 2 : 0;
  const auto value =
      words.size() == 2 || words.size() == 5 ? geom::parse_number(words[name + 1]) : std::nullopt;
  if (!value) {
    throw geom::InputError(
        source, number,
        {.expected = "a parameter (its name and its value, or five columns of QGroundControl)",
         .found = geom::in_quotes(geom::excerpt(line))});
  }
  take_value(words[name], *value, source, number, out);
}

AutopilotSettings read_log(std::istream& in, std::string_view source) {
  const UlogSummary summary = read_ulog(in, source, {}, [](const UlogMessage&) {});
  if (summary.parameters.empty())
    refuse(source, {.expected = "parameters in the log", .found = "none"});
  if (!summary.has_data) {
    refuse(source, {.expected = "a log that goes on after its parameters",
                    .found = "one that ends among them",
                    .advice = "those that are missing would count as the firmware's"});
  }
  return {summary.parameters, {}, {}};
}

// --- meaning ----------------------------------------------------------------------------------

void require_multirotor(const AutopilotSettings& settings, std::string_view source) {
  for (const char* name : kOtherVehicles) {
    // A PX4 multirotor's file may have all parameters of fixed wings beside its own.
    if (std::string_view(name).starts_with("FW_") && settings.values.contains("MPC_XY_CRUISE")) {
      continue;
    }
    if (!settings.values.contains(name)) continue;
    refuse(source, {.expected = "parameters of a multirotor",
                    .found = fmt::format("{}, which another class of vehicles has", name)});
  }
  const bool rotors = settings.vehicle.empty() ||
                      settings.vehicle.find("otor") != std::string::npos ||
                      settings.vehicle.find("opter") != std::string::npos;
  if (!rotors) {
    refuse(source, {.expected = "parameters of a multirotor",
                    .found = fmt::format("those of \"{}\"", geom::excerpt(settings.vehicle))});
  }
  constexpr double kMultirotors[] = {2, 3, 4, 13, 14, 15, 29};  // MAV_TYPE
  const auto type = settings.values.find("MAV_TYPE");
  if (type == settings.values.end() || std::find(std::begin(kMultirotors), std::end(kMultirotors),
                                                 type->second) != std::end(kMultirotors)) {
    return;
  }
  refuse(source, {.expected = "MAV_TYPE of a multirotor (2, 3, 4, 13, 14, 15, 29)",
                  .found = fmt::to_string(type->second)});
}

template <std::size_t N>
std::size_t known(const AutopilotSettings& settings, const Parameter (&table)[N]) {
  return static_cast<std::size_t>(
      std::count_if(std::begin(table), std::end(table),
                    [&](const Parameter& one) { return settings.values.contains(one.name); }));
}

template <std::size_t N>
void take_all(const AutopilotSettings& settings, const Parameter (&table)[N],
              std::string_view source, SetAutopilot& out) {
  for (const Parameter& one : table) {
    double& field = out.autopilot.*one.field;
    const auto found = settings.values.find(one.name);
    if (found == settings.values.end()) {
      out.assumed.push_back(fmt::format("{} {:.6g}", one.name, field / one.unit));
      continue;
    }
    if (!(found->second >= one.least && found->second <= one.most)) {
      refuse(source, {.key = std::string(one.name),
                      .expected = fmt::format("from {:g} to {:g}", one.least, one.most),
                      .found = fmt::format("{:g}", found->second)});
    }
    field = found->second * one.unit;
    out.says_return_height = out.says_return_height || one.field == &Autopilot::return_height;
  }
}

// A half angle of 0: no cone; of 90 degrees: at the return's height from everywhere.
void take_cone(const AutopilotSettings& settings, std::string_view source, SetAutopilot& out) {
  const auto angle = settings.values.find("RTL_CONE_ANG");
  if (angle == settings.values.end()) {
    out.assumed.emplace_back("RTL_CONE_ANG 45");
    return;
  }
  const double degrees = angle->second;
  if (!(degrees >= 0 && degrees <= 90)) {
    refuse(
        source,
        {.key = "RTL_CONE_ANG", .expected = "from 0 to 90", .found = fmt::format("{:g}", degrees)});
  }
  out.autopilot.return_slope =
      degrees > 0 ? 1 / std::tan(std::min(degrees, 89.0) * std::numbers::pi / 180) : 0;
}

// Parameters that go before others where they are set, and no default has.
void take_overrides(const AutopilotSettings& settings, Autopilot& out) {
  const auto value = [&](const char* name) {
    const auto found = settings.values.find(name);
    return found == settings.values.end() ? 0 : std::max(0.0, found->second);
  };
  if (out.firmware == Firmware::px4) {
    if (const double all = value("MPC_Z_VEL_ALL"); all > 0) out.climb = out.descent = all;
    if (const double all = value("MPC_XY_VEL_ALL"); all > 0) out.speed = all;
    out.climb = std::max(out.climb, value("MPC_TKO_SPEED"));
    out.descent = std::max(out.descent, value("MPC_LAND_SPEED"));
  } else {
    out.speed = std::max({out.speed, value("RTL_SPEED") * 0.01, value("RTL_SPEED_MS")});
    out.descent = std::max({out.descent, value("LAND_SPEED") * 0.01, value("LAND_SPD_MS"),
                            value("LAND_SPEED_HIGH") * 0.01, value("LAND_SPD_HIGH_MS")});
  }
}

// PX4 (MulticopterPositionControl::parameters_update) works out others from this one.
void take_responsiveness(const AutopilotSettings& settings, std::string_view source,
                         Autopilot& out) {
  const auto found = settings.values.find("SYS_VEHICLE_RESP");
  if (found == settings.values.end() || found->second < 0) return;
  if (found->second > 1) {
    refuse(source, {.key = "SYS_VEHICLE_RESP",
                    .expected = "at most 1",
                    .found = fmt::format("{:g}", found->second)});
  }
  const double share = found->second * found->second;
  out.acceleration = std::lerp(1.0, 15.0, share);
  out.jerk = std::lerp(1.0, 25.0, share);
}

void take_return_type(const AutopilotSettings& settings, SetAutopilot& out) {
  const auto type = settings.values.find("RTL_TYPE");
  if (type == settings.values.end()) {
    out.assumed.emplace_back("RTL_TYPE 0");
  } else {
    out.autopilot.returns_home = type->second == 0;
  }
}

// A multicopter of 1.16 and later that waits before it lands descends as older ones always do. One
// that waits for ever (below 0) does not land.
void take_land_delay(const AutopilotSettings& settings, Autopilot& out) {
  const auto delay = settings.values.find("RTL_LAND_DELAY");
  if (delay != settings.values.end() && delay->second != 0) out.descends_aslant = true;
  if (delay != settings.values.end() && delay->second < 0) out.returns_home = false;
}

void take_home_as_rally(const AutopilotSettings& settings, SetAutopilot& out) {
  const auto home = settings.values.find("RALLY_INCL_HOME");
  if (home == settings.values.end()) {
    out.assumed.emplace_back("RALLY_INCL_HOME 1");
  } else {
    out.autopilot.home_is_a_place = home->second != 0;
  }
}

// Ways around obstacles and fences, heights above a terrain that is not known here, a landing
// beside a beacon, a return that ends in the air: then nobody knows where a return goes, and some
// of these count in a mission, too. All of them are off by default.
void take_unknown_ways(const AutopilotSettings& settings, Autopilot& out) {
  const auto any_on = [&](std::initializer_list<const char*> names) {
    return std::any_of(names.begin(), names.end(), [&](const char* name) {
      const auto found = settings.values.find(name);
      return found != settings.values.end() && found->second != 0;
    });
  };
  const auto above_0 = [&](const char* name) {
    const auto found = settings.values.find(name);
    return found != settings.values.end() && found->second > 0;
  };
  out.keeps_to_legs = !any_on({"OA_TYPE", "COM_OBS_AVOID"}) && !above_0("NAV_MIN_GND_DIST");
  out.climbs_to_hold = above_0("MIS_LTRMIN_ALT");
  out.lands_below = !any_on({"PLND_ENABLED"});
  if (any_on({"RTL_PLD_MD", "RTL_ALT_TYPE", "RTL_ALT_FINAL", "RTL_ALT_FINAL_M"}) ||
      !out.keeps_to_legs || !out.lands_below) {
    out.returns_home = false;
  }
}

// What it does when a link is lost: of the remote control, or of the ground station. One of them
// that makes it return is enough, since many fly with one link alone.
void take_lost_links(const AutopilotSettings& settings, Autopilot& out) {
  struct LostLink {
    const char* action;
    double returns;
    const char* exceptions;  // whose bit makes it go on with its mission
    unsigned bit;
  };
  constexpr LostLink kLinks[] = {{"NAV_RCL_ACT", 2, "COM_RCL_EXCEPT", 1},
                                 {"NAV_DLL_ACT", 2, "COM_DLL_EXCEPT", 1},
                                 {"FS_THR_ENABLE", 1, "FS_OPTIONS", 1},
                                 {"FS_GCS_ENABLE", 1, "FS_OPTIONS", 2}};
  constexpr double kNoSticks = 4;  // COM_RC_IN_MODE: PX4 has no remote control to lose
  const auto value = [&](const char* name) -> std::optional<double> {
    const auto found = settings.values.find(name);
    return found == settings.values.end() ? std::nullopt : std::optional(found->second);
  };
  bool said = false;
  bool returns = false;
  for (const LostLink& link : kLinks) {
    if (link.action == kLinks[0].action && value("COM_RC_IN_MODE") == kNoSticks) {
      said = true;
      continue;
    }
    const auto action = value(link.action);
    const double bits = std::clamp(value(link.exceptions).value_or(0), 0.0, 65535.0);
    const bool goes_on = (static_cast<unsigned>(bits) & link.bit) != 0;
    said = said || action || goes_on;
    returns = returns || (action == link.returns && !goes_on);
  }
  out.returns_if_lost = returns || !said;
}

// How it follows terrain (AC_WPNav::get_terrain_offset): a rangefinder goes before its own terrain.
void take_terrain(const AutopilotSettings& settings, std::string_view source, Autopilot& out) {
  const auto value = [&](const char* name, double usual, double least, double most) {
    const auto found = settings.values.find(name);
    if (found == settings.values.end()) return usual;
    if (found->second >= least && found->second <= most) return found->second;
    refuse(source, {.key = name,
                    .expected = fmt::format("from {:g} to {:g}", least, most),
                    .found = fmt::format("{:g}", found->second)});
  };
  out.terrain_spacing = value("TERRAIN_SPACING", out.terrain_spacing, 1, 10000);
  for (const char* name : {"WPNAV_TER_MARGIN", "WP_TER_MARGIN", "WP_TER_MARGIN_M"}) {
    out.terrain_lag = value(name, out.terrain_lag, 0.1, 100);
  }
  double uses_rangefinder = 1;
  for (const char* name : {"WPNAV_RFND_USE", "WP_RFND_USE"}) {
    uses_rangefinder = value(name, uses_rangefinder, 0, 1);
  }
  const bool has_rangefinder =
      std::any_of(settings.values.begin(), settings.values.end(), [](const auto& one) {
        return one.first.starts_with("RNGFND") && one.first.ends_with("_TYPE") && one.second != 0;
      });
  // Without its adjustment the terrain counts from the sea, not from where the vehicle armed.
  const bool adjusts = value("TERRAIN_OFS_MAX", 30, 0, 50) > 0;
  out.follows_terrain = value("TERRAIN_ENABLE", 1, 0, 1) != 0 && adjusts &&
                        !(has_rangefinder && uses_rangefinder != 0);
}

// The autopilot of that firmware: the one asked for, or of the file's version.
Autopilot pilot_of(Firmware firmware, const AutopilotSettings& settings,
                   const std::vector<Autopilot>& asked, std::string_view source) {
  const std::string word = firmware == Firmware::px4 ? "px4" : "ardupilot";
  const auto same = std::find_if(asked.begin(), asked.end(),
                                 [&](const Autopilot& one) { return one.firmware == firmware; });
  if (same == asked.end()) {
    refuse(source, {.expected = fmt::format("parameters of {}", names_of(asked)),
                    .found = fmt::format("those of {}", word)});
  }
  const bool one_version = same->name.find('-') == std::string::npos;
  if (settings.version.empty() || one_version) return *same;
  if (const auto exact = autopilots_of(word + ":" + settings.version)) return exact->front();
  refuse(source,
         {.expected = fmt::format("parameters of a version that is modelled ({})", same->name),
          .found = fmt::format("version {}; --autopilot {} takes all of them for possible",
                               settings.version, word)});
}

}  // namespace

AutopilotSettings read_autopilot_settings(std::istream& in, std::string_view source) {
  if (in.peek() == 'U') return read_log(in, source);
  AutopilotSettings out;
  std::string text;
  for (std::size_t number = 1; std::getline(in, text); ++number) {
    std::string_view line = geom::trimmed(text);
    if (number == 1 && line.starts_with("\xef\xbb\xbf")) line.remove_prefix(3);
    if (line.empty()) continue;
    if (line.front() == '#') {
      take_comment(line, out);
    } else {
      take_line(line, source, number, out);
    }
  }
  if (out.values.empty()) refuse(source, {.expected = "parameters", .found = "none"});
  return out;
}

SetAutopilot set_autopilot(const AutopilotSettings& settings, const std::vector<Autopilot>& asked,
                           std::string_view source) {
  require_multirotor(settings, source);
  const std::size_t px4 = known(settings, kPx4);
  const std::size_t metres = known(settings, kArdupilotMetres);
  const std::size_t centimetres = known(settings, kArdupilot);
  const std::size_t always = known(settings, kArdupilotAlways);
  if (px4 + metres + centimetres + always == 0) {
    refuse(
        source,
        {.expected =
             "parameters of PX4 (NAV_ACC_RAD …) or ArduPilot Copter (WPNAV_RADIUS, WP_RADIUS_M …)",
         .found = "none of those that say how missions are flown"});
  }
  if (px4 > 0 && metres + centimetres + always > 0) {
    refuse(source, {.expected = "parameters of PX4 or of ArduPilot Copter", .found = "both"});
  }
  const Firmware firmware = px4 > 0 ? Firmware::px4 : Firmware::ardupilot;
  SetAutopilot out{pilot_of(firmware, settings, asked, source), {}};
  if (firmware == Firmware::px4) {
    take_all(settings, kPx4, source, out);
    take_cone(settings, source, out);
    take_return_type(settings, out);
    take_land_delay(settings, out.autopilot);
    take_responsiveness(settings, source, out.autopilot);
    set_px4_fence(settings, source, out.autopilot);
  } else if (metres > 0 && centimetres > 0) {
    refuse(
        source,
        {.expected =
             "ArduPilot's parameters in centimetres (WPNAV_RADIUS …) or in metres (WP_RADIUS_M …)",
         .found = "both"});
  } else if (metres >= centimetres) {
    take_all(settings, kArdupilotMetres, source, out);
  } else {
    take_all(settings, kArdupilot, source, out);
  }
  if (firmware == Firmware::ardupilot) {
    take_all(settings, kArdupilotAlways, source, out);
    take_home_as_rally(settings, out);
    set_ardupilot_fence(settings, out.autopilot);
    take_terrain(settings, source, out.autopilot);
  }
  take_unknown_ways(settings, out.autopilot);
  take_lost_links(settings, out.autopilot);
  take_overrides(settings, out.autopilot);
  return out;
}

}  // namespace traj
