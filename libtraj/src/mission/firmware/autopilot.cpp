#include "traj/mission/firmware/autopilot.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace traj {
namespace {

constexpr std::string_view kPx4Versions[] = {"1.11", "1.12", "1.13", "1.14",
                                             "1.15", "1.16", "1.17"};
constexpr std::string_view kArdupilotVersions[] = {"4.3", "4.4", "4.5", "4.6", "4.7"};

template <std::size_t N>
std::string full_name(std::string_view firmware, std::string_view version,
                      const std::string_view (&versions)[N]) {
  if (!version.empty()) return fmt::format("{}:{}", firmware, version);
  return fmt::format("{}:{}-{}", firmware, versions[0], versions[N - 1]);
}

template <std::size_t N>
bool knows(std::string_view version, const std::string_view (&versions)[N]) {
  return version.empty() ||
         std::find(std::begin(versions), std::end(versions), version) != std::end(versions);
}

}  // namespace

// FlightTaskAuto::_getCurrentState compares the distance from the leg with the item's radius since
// 1.12 (1.11: with the cruise speed); Mission and
// MissionBlock::is_mission_item_reached_or_completed have the rest.
Autopilot px4(std::string_view version) {
  Autopilot out;
  out.firmware = Firmware::px4;
  out.name = full_name("px4", version, kPx4Versions);
  out.acceptance = 10;
  out.height_acceptance = 0.8;
  out.speed = 5;
  out.climb = 3;
  out.descent = 1.5;
  out.acceleration = 3;
  out.jerk = 4;
  out.takeoff_height = 2.5;
  out.return_height = 30;  // of multicopters (rc.mc_defaults), as RTL_DESCEND_ALT
  out.return_slope = 1;
  out.return_near = 10;
  out.return_descend = 10;
  out.cone_of_px4_1_11 = version.empty() || version == "1.11";
  out.cone_of_px4_1_12 = version != "1.11";
  const bool newest = version == "1.16" || version == "1.17";
  out.cone_above_return = !newest && version != "1.11";
  out.descends_aslant = !newest;
  out.rally_adds = true;
  out.heeds_item_radius = true;
  out.least_radius = version == "1.11" ? 0 : kLeastLineRadius;
  out.tracking = {0.47, 0.47, 0.47};
  out.from_stop = {20, 2.5};
  out.from_corner = {80, 7};
  out.bulge = 0.013;
  out.run_on = 0.3;
  set_drag(out, kUsualDrag);
  return out;
}

// AC_WPNav::advance_wp_target_along_track and SCurve::advance_target_along_track turn the corner;
// Copter's ModeRTL builds the return; AC_PosControl's integrator of velocity, wound up against
// drag, overshoots.
Autopilot ardupilot(std::string_view version) {
  Autopilot out;
  out.firmware = Firmware::ardupilot;
  out.name = full_name("ardupilot", version, kArdupilotVersions);
  out.acceptance = 2;
  out.speed = 10;
  out.climb = 2.5;
  out.descent = 1.5;
  out.acceleration = 2.5;
  out.jerk = 1;
  out.return_height = 15;
  out.return_slope = 3;
  out.rally_limit = 300;
  out.turns_by_s_curve = true;
  out.tracking = {0.25, 0.25, 0.25};
  out.overshoot = 0.1;
  out.from_stop = out.from_corner = {15, 2.5};
  out.fall = 10;
  out.terrain_spacing = 100;
  out.terrain_lag = 10;
  // FENCE_ALT_MAX, FENCE_RADIUS and FENCE_MARGIN
  out.switched_fence = {.top = 100, .bottom = {}, .across = 300, .return_ceiling = 98};
  set_drag(out, kUsualDrag);
  return out;
}

// Both wind up an integrator of velocity against drag; PX4 keeps to its way where drag is little.
// ArduPilot flew its own model alone, so that less drag does not count for it.
void set_drag(Autopilot& autopilot, double drag) {
  constexpr double kLittle = 0.15;  // 1/s
  autopilot.drag = drag;
  if (autopilot.firmware == Firmware::ardupilot) {
    autopilot.overshoot_time = std::max(0.12, 0.2 * drag);
    return;
  }
  autopilot.overshoot_time = 0.25 * std::max(0.0, drag - 0.1);
  autopilot.climbs_ahead = drag > kLittle;
  autopilot.fall = drag > kLittle ? 12 + 12 * drag : 12;
}

std::optional<std::vector<Autopilot>> autopilots_of(std::string_view words) {
  if (words == "any") return std::vector{px4(), ardupilot()};
  const std::size_t colon = words.find(':');
  const std::string_view firmware = words.substr(0, colon);
  const std::string_view version =
      colon == std::string_view::npos ? std::string_view() : words.substr(colon + 1);
  if (colon != std::string_view::npos && version.empty()) return std::nullopt;
  if (firmware == "px4" && knows(version, kPx4Versions)) return std::vector{px4(version)};
  if (firmware == "ardupilot" && knows(version, kArdupilotVersions)) {
    return std::vector{ardupilot(version)};
  }
  return std::nullopt;
}

std::string autopilot_words() {
  return fmt::format("any, px4, px4:{} to px4:{}, ardupilot, ardupilot:{} to ardupilot:{}",
                     kPx4Versions[0], *std::prev(std::end(kPx4Versions)), kArdupilotVersions[0],
                     *std::prev(std::end(kArdupilotVersions)));
}

std::string names_of(std::span<const Autopilot> autopilots) {
  std::string out;
  for (const Autopilot& one : autopilots) out += (out.empty() ? "" : ", ") + one.name;
  return out;
}

double s_curve_length(const Autopilot& autopilot, double speed) {
  const double a = autopilot.acceleration;
  return speed * speed / (2 * a) + speed * a / (2 * autopilot.jerk);
}

}  // namespace traj
