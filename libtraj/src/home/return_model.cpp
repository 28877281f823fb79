#include "traj/home/return_model.h"

#include <algorithm>

namespace traj {
namespace {

constexpr double kReaction = 0.3;           // s from the order until it slows down
constexpr double kArdupilotLandsLater = 1;  // s: flown, 0.9
constexpr double kPx4StopPoint = 0.6;       // s
constexpr double kPx4Nearer = 2;            // m: MIN_DIST_THRESHOLD
constexpr double kPx4RallyApart = 10;       // m: MAX_DIST_FROM_HOME_FOR_LAND_APPROACHES
constexpr double kDjiDeceleration = 3;      // m/s2
constexpr double kDjiSpeed = 15;            // m/s, the most that it returns with
constexpr double kDjiClimb = 6;             // m/s
constexpr double kDjiLowWithin = 50;        // m from home

ReturnCone cone_of(const Autopilot& autopilot) {
  ReturnCone out;
  out.px4_1_11 = autopilot.cone_of_px4_1_11;
  out.px4_1_12 = autopilot.cone_of_px4_1_12;
  out.above_height = autopilot.cone_above_return;
  out.near = autopilot.return_near;
  out.descend = autopilot.return_descend;
  return out;
}

// PX4's RTL::findRtlDestination (1.11 compares degrees), ArduPilot's
// AP_Rally::calc_best_rally_or_home_location.
void set_places(const Autopilot& autopilot, ReturnModel& out) {
  if (autopilot.firmware == Firmware::px4) {
    out.nearer = kPx4Nearer;
    out.rally_apart = kPx4RallyApart;
    out.any_place = autopilot.cone_of_px4_1_11;
    return;
  }
  out.rally_limit = autopilot.rally_limit;
  out.home_is_a_place = autopilot.home_is_a_place;
  out.fence_excludes = autopilot.rally_in_fence;
}

// PX4's position smoothing keeps to its jerk, also from one mode to the next; to land or to hold it
// stops at a point that is 0.6 s of its speed further than even braking (Navigator's
// preproject_stop_point). ArduPilot aims at a point where it can stop evenly
// (AC_PosControl::get_stopping_point_NE), but not to land.
void set_stop(const Autopilot& autopilot, ReturnModel& out) {
  out.reaction = kReaction;
  out.deceleration = autopilot.acceleration;
  out.jerk = autopilot.jerk;
  if (autopilot.firmware == Firmware::ardupilot) {
    out.stop_length = out.deceleration / 2;
    out.landing_later = kArdupilotLandsLater;
    return;
  }
  out.ramp = out.deceleration / (2 * out.jerk);
  out.fading = 2 * out.ramp;
  out.stops_on_line = true;
  out.reaction = std::max(kReaction, kPx4StopPoint - out.ramp);
}

}  // namespace

ReturnModel return_model(const Autopilot& autopilot) {
  ReturnModel out;
  out.autopilot = autopilot.name;
  out.height = autopilot.return_height;
  out.least_climb = autopilot.return_climb;
  out.slope = autopilot.return_slope;
  out.ceiling = autopilot.fence.return_ceiling;
  out.keeps_below_ceiling = !autopilot.highest_item;  // newer versions do not
  out.cone = cone_of(autopilot);
  // A lost link makes PX4 hold before it returns (COM_FAIL_ACT_T).
  out.known = autopilot.returns_home && !autopilot.climbs_to_hold;
  out.rally_adds = autopilot.rally_adds;
  set_places(autopilot, out);
  set_stop(autopilot, out);
  if (autopilot.firmware == Firmware::px4) out.sideways = autopilot.overshoot_time / 2;
  out.overshoot_time = autopilot.overshoot_time;
  out.overshoot = autopilot.overshoot;
  out.speed = autopilot.speed;
  out.climb = autopilot.climb;
  out.descent = autopilot.descent;
  out.under = autopilot.turns_by_s_curve ? s_curve_length(autopilot, autopilot.climb)
                                         : autopilot.height_acceptance;
  out.acceptance = autopilot.acceptance;
  out.fall = autopilot.fall;
  out.aslant = autopilot.descends_aslant;
  out.around = autopilot.tracking;
  return out;
}

ReturnModel dji_return_model(double height) {
  ReturnModel out;
  out.autopilot = "dji";
  out.height = height;
  out.low_within = kDjiLowWithin;
  out.reaction = kReaction;
  out.deceleration = kDjiDeceleration;
  out.jerk = kDjiDeceleration;
  out.ramp = out.deceleration / (2 * out.jerk);
  out.fading = 2 * out.ramp;
  out.stops_on_line = true;
  out.speed = kDjiSpeed;
  out.climb = kDjiClimb;
  out.descent = kDjiClimb;
  return out;
}

double braking_factor(const ReturnModel& model, double fastest) {
  return model.reaction + fastest / (2 * model.deceleration) + model.ramp + model.overshoot_time;
}

double braking_way(const ReturnModel& model, double speed) {
  return speed * braking_factor(model, speed) + model.stop_length + model.overshoot;
}

}  // namespace traj
