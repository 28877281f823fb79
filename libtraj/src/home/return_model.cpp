#include "traj/home/return_model.h"

#include <algorithm>

namespace traj {
namespace {

constexpr double kReaction = 0.3;       // s from the order until it slows down
constexpr double kDjiDeceleration = 3;  // m/s2
constexpr double kDjiSpeed = 15;        // m/s, the most that it returns with
constexpr double kDjiClimb = 6;         // m/s
constexpr double kDjiLowWithin = 50;    // m from home

}  // namespace

ReturnModel return_model(const Autopilot& autopilot) {
  ReturnModel out;
  out.autopilot = autopilot.name;
  out.height = autopilot.return_height;
  out.least_climb = autopilot.return_climb;
  out.slope = autopilot.return_slope;
  out.known = autopilot.returns_home;
  out.rally_adds = autopilot.rally_adds;
  out.home_always = autopilot.firmware == Firmware::ardupilot;
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
