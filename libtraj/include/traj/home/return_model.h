#pragma once

// How a vehicle leaves its mission and comes home by itself: an autopilot's return, as numbers.
//
// Example:
//   const traj::ReturnModel model = traj::return_model(traj::px4("1.17"));
//   assert(model.height == 30 && traj::braking_way(model, 5) > 25.0 / 6);

#include <optional>
#include <string>
#include <string_view>

#include "geom/text/words.h"
#include "traj/mission/firmware/autopilot.h"

namespace traj {

// What it does when the link is lost, or the operator asks for it.
enum class ReturnAction {
  rtl,   // to home or a rally point at the return height, and land there
  land,  // brake, and land below
  hold   // brake, and stay
};
inline constexpr geom::Words<ReturnAction, 3> kReturnActionWords{{
    {ReturnAction::rtl, "rtl"},
    {ReturnAction::land, "land"},
    {ReturnAction::hold, "hold"},
}};
constexpr std::string_view name(ReturnAction action) {
  return geom::word_of(kReturnActionWords, action);
}

// By which rules the height of a return depends on the distance from its place; a firmware's
// versions may have several. Without one of these: slope times the distance, from anywhere.
struct ReturnCone {
  bool px4_1_11 = false;  // `descend` within `near`; else slope times the distance, and `descend`
  bool px4_1_12 = false;  // twice the distance within the acceptance; the slope within `near`
  bool above_height = false;  // of px4_1_12: up to twice the acceptance, even above the height
  double near = 0;            // m
  double descend = 0;         // m
};

struct ReturnModel {
  std::string autopilot;   // as reports name it
  double height = 0;       // m above the place it returns to, or above home (rally_adds)
  double least_climb = 0;  // m that it climbs at least
  double slope = 0;        // height over distance of the cone in which it stays low; 0: none
  double low_within = 0;   // m from home within which it may stay low (DJI)
  std::optional<double> ceiling = {};  // m above home: it climbs no higher (a fence)
  bool keeps_below_ceiling = true;     // false: it may climb higher, too
  ReturnCone cone = {};
  bool known = true;        // false: it may go where nobody knows (RTL_TYPE)
  bool rally_adds = false;  // `height` counts from a rally point; else from home

  // Which of home and the rally points it returns to.
  double nearer = 0;            // m: the place may be so much further than the nearest
  bool any_place = false;       // it may take any of them
  double rally_apart = 0;       // m: it may leave out rally points that are nearer to home
  double rally_limit = 0;       // m: it goes home if every rally point is further; 0: none
  bool home_is_a_place = true;  // of which the nearest counts; else home is the last resort
  bool fence_excludes = false;  // it may leave out rally points for a fence

  // How it stops: seconds until it begins, the deceleration and its jerk, and what it overshoots.
  double reaction = 0;         // s
  double deceleration = 1;     // m/s2
  double jerk = 1;             // m/s3
  double ramp = 0;             // s: times the speed, while its deceleration builds up,
  double stop_length = 0;      // m: and this, of a firmware that aims at a point where it stops
  double landing_later = 0;    // s: times the speed, if it is to land where it stops
  double fading = 0;           // s until an acceleration has faded, if it is told while speeding up
  bool stops_on_line = false;  // up or down it slows down no sooner than across
  double overshoot_time = 0;   // s: times the speed,
  double overshoot = 0;        // m: and this
  double sideways = 0;         // s: times the speed, to either side of its way to rest

  double speed = 0;            // m/s that it returns with
  double climb = 0;            // m/s
  double descent = 0;          // m/s
  double under = 0;            // m below its height from which it may go across
  double acceptance = 0;       // m from the place where it may begin to sink
  double fall = 0;             // m that it sinks until it is above its place
  bool aslant = false;         // it sinks on a straight line to cone.descend above its place, if it
                               // is higher, before it lands
  Vec3 around = Vec3::Zero();  // m along each axis that it may be off all this
};

ReturnModel return_model(const Autopilot& autopilot);

// DJI's, as its documentation of WPML says it: up to `height` above the take-off, level to above
// it, and down; from within 50 m at any height. Its firmware is not public: brakes with 3 m/s2.
ReturnModel dji_return_model(double height);

// The stopping distance, m, from a steady speed, m/s: the reaction, the braking and the overshoot.
double braking_way(const ReturnModel& model, double speed);
// Seconds by which a velocity is multiplied for its way to rest, `overshoot` left out, if no
// velocity is larger than `fastest` m/s. Grows with it.
double braking_factor(const ReturnModel& model, double fastest);

}  // namespace traj
