#include "traj/home/return_model.h"

#include <algorithm>

namespace traj {
namespace {

constexpr double kReaction = 0.3;       // s from the order until it slows down
constexpr double kPx4Nearer = 2;        // m: MIN_DIST_THRESHOLD
constexpr double kPx4RallyApart = 10;   // m: MAX_DIST_FROM_HOME_FOR_LAND_APPROACHES
constexpr double kLeastSlope = 0.5;     // of ArduPilot's cone: RTL_MIN_CONE_SLOPE
constexpr double kFlatCone = 0.018;     // slope of a cone of 90 degrees, which PX4 1.11 leaves out
constexpr double kDjiDeceleration = 3;  // m/s2
constexpr double kDjiSpeed = 15;        // m/s, the most that it returns with
constexpr double kDjiClimb = 6;         // m/s
constexpr double kDjiLowWithin = 50;    // m from home

ReturnCone cone_of(const Autopilot& autopilot) {
  ReturnCone out;
  out.px4_1_11 = autopilot.cone_of_px4_1_11;
  out.px4_1_12 = autopilot.cone_of_px4_1_12;
  out.above_height = autopilot.cone_above_return;
  out.ardupilot = !out.px4_1_11 && !out.px4_1_12;
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

// --- heights, by the distance from the place, with which they grow ------------------------------

double ardupilot_height(const ReturnModel& model, double full, double away) {
  return model.slope >= kLeastSlope ? std::min(full, model.slope * away) : full;
}

double px4_1_11_height(const ReturnModel& model, double full, double away) {
  const double descend = model.cone.descend;
  if (away <= model.cone.near) return descend;
  if (model.slope <= 0) return std::max(full, descend);
  if (model.slope < kFlatCone) return descend;
  return std::max(std::min(model.slope * away, full), descend);
}

// With this radius of acceptance, the greatest; and the least with any that is smaller.
double px4_1_12_height(const ReturnModel& model, double full, double away) {
  if (away <= model.acceptance) return std::min(2 * away, full);
  const double cone = away <= model.cone.near && model.slope > 0 ? model.slope * away : full;
  return std::min(full, std::max(cone, 2 * model.acceptance));
}

double least_px4_1_12_height(const ReturnModel& model, double full, double away) {
  const double cone = away <= model.cone.near && model.slope > 0 ? model.slope * away : full;
  return std::min({full, cone, away <= model.acceptance ? 2 * away : full});
}

}  // namespace

HeightRange return_heights(const ReturnModel& model, double full, double nearest, double furthest) {
  HeightRange out{full, 0};
  const auto add = [&](auto low, auto high) {
    out.least = std::min(out.least, low(model, full, nearest));
    out.most = std::max(out.most, high(model, full, furthest));
  };
  const ReturnCone& cone = model.cone;
  if (cone.ardupilot) add(ardupilot_height, ardupilot_height);
  if (cone.px4_1_11) add(px4_1_11_height, px4_1_11_height);
  if (cone.px4_1_12) add(least_px4_1_12_height, px4_1_12_height);
  if (cone.px4_1_12 && model.slope <= 0) out.most = std::max(out.most, full);
  if (cone.above_height) {
    out.most = std::max(out.most, 2 * std::min(furthest, model.acceptance));
  }
  if (model.low_within > 0) out.most = full;
  if (nearest < model.low_within) out.least = 0;
  return out;
}

ReturnModel return_model(const Autopilot& autopilot) {
  ReturnModel out;
  out.autopilot = autopilot.name;
  out.height = autopilot.return_height;
  out.least_climb = autopilot.return_climb;
  out.slope = autopilot.return_slope;
  out.ceiling = autopilot.return_ceiling;
  out.cone = cone_of(autopilot);
  out.known = autopilot.returns_home;
  out.rally_adds = autopilot.rally_adds;
  set_places(autopilot, out);
  out.reaction = kReaction;
  out.deceleration = autopilot.acceleration;
  out.jerk = autopilot.jerk;
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
  out.speed = kDjiSpeed;
  out.climb = kDjiClimb;
  out.descent = kDjiClimb;
  return out;
}

double braking_factor(const ReturnModel& model, double fastest) {
  return model.reaction + fastest / (2 * model.deceleration) +
         model.deceleration / (2 * model.jerk) + model.overshoot_time;
}

double braking_way(const ReturnModel& model, double speed) {
  return speed * braking_factor(model, speed) + model.overshoot;
}

}  // namespace traj
