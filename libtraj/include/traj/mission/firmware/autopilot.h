#pragma once

// Autopilots as numbers: how far each strays from the way that a mission file describes.
//
// Example:
//   const std::vector<traj::Autopilot> any = *traj::autopilots_of("any");
//   assert(any.size() == 2 && traj::names_of(any).starts_with("px4:1.11-"));
//   traj::Autopilot heavy = traj::px4("1.15");
//   traj::set_drag(heavy, 0.2);  // 1/s: little drag for its mass, so that stops are overshot less

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geom/base/vec3.h"

namespace traj {

using geom::Vec3;

// PX4 from 1.12 on leaves the line before an item whose radius is smaller, m.
inline constexpr double kLeastLineRadius = 2;

// The drag over the mass of an unknown airframe, 1/s: more than quadrotors in the
// literature have (0.54: Faessler, Franchi and Scaramuzza 2018).
inline constexpr double kUsualDrag = 0.6;

enum class Firmware { px4, ardupilot };

// How much of the next leg it takes until a deviation has decayed: metres, and seconds at its
// speed.
struct Settling {
  double distance = 0;
  double time = 0;
};

// A fence around home that parameters make, as far as it acts, m.
struct ParameterFence {
  std::optional<double> top;             // above home: FENCE_ALT_MAX, GF_MAX_VER_DIST
  std::optional<double> bottom;          // likewise, once it was above that: FENCE_ALT_MIN
  std::optional<double> across;          // from home: FENCE_RADIUS, GF_MAX_HOR_DIST
  std::optional<double> return_ceiling;  // above home: a return climbs no higher
};

// The accelerations, m/s2, from which PX4 works out where it could stop: its fence acts where that
// is beyond it (GF_PREDICT).
struct Foresight {
  double across = 0;    // at first: MPC_ACC_HOR_MAX
  double up = 0;        // at first: MPC_ACC_UP_MAX, MPC_ACC_DOWN_MAX
  double slows_up = 0;  // then: MPC_ACC_DOWN_MAX
};

// One firmware with its parameters. The defaults are those of the firmware's own code; the numbers
// under "measured" come from flights of the firmware (docs/firmware.md says which hold which).
struct Autopilot {
  Firmware firmware = Firmware::px4;
  std::string name;  // in reports: "px4:1.11-1.17"

  // Parameters, SI.
  double acceptance = 0;          // m: NAV_ACC_RAD, WPNAV_RADIUS
  double height_acceptance = 0;   // m: NAV_MC_ALT_RAD; ArduPilot has none
  double speed = 0;               // m/s where the file says none: MPC_XY_CRUISE, WPNAV_SPEED
  double climb = 0;               // m/s at most: MPC_Z_V_AUTO_UP, WPNAV_SPEED_UP
  double descent = 0;             // m/s at most: MPC_Z_V_AUTO_DN, WPNAV_SPEED_DN
  double acceleration = 0;        // m/s2: MPC_ACC_HOR, WPNAV_ACCEL
  double jerk = 0;                // m/s3: MPC_JERK_AUTO, WPNAV_JERK
  double takeoff_height = 0;      // m above home, at least: MIS_TAKEOFF_ALT
  double return_height = 0;       // m above home: RTL_RETURN_ALT, RTL_ALT
  double return_climb = 0;        // m that a return climbs at least: RTL_CLIMB_MIN
  double return_slope = 0;        // height over distance of the cone; 0: none. RTL_CONE_*
  double return_near = 0;         // m from its place within which PX4's cone counts: RTL_MIN_DIST
  double return_descend = 0;      // m above its place: RTL_DESCEND_ALT
  bool descends_aslant = false;   // to return_descend, before it lands: PX4 until 1.15, and later
                                  // ones that wait there (RTL_LAND_DELAY)
  ParameterFence fence;           // beyond which it leaves its mission; none by default
  ParameterFence switched_fence;  // what an item of the mission (207) makes of that
  std::optional<Foresight> foresight;  // its fence acts early: GF_PREDICT; not by default
  // m above home: it flies an item that is higher no higher than this. PX4 until 1.14:
  // LNDMC_ALT_MAX.
  std::optional<double> highest_item;
  double rally_limit = 0;       // m: home if every rally point is further; 0: none. RALLY_LIMIT_KM
  bool home_is_a_place = true;  // of which the nearest counts; else a last resort. RALLY_INCL_HOME
  bool rally_in_fence = false;  // it leaves out rally points outside of its fence: FENCE_ENABLE
  bool rally_adds = false;      // to a rally point it returns so high above that point
  bool returns_home = true;     // false: nobody knows where a return goes (RTL_TYPE, OA_TYPE, ...)
  bool climbs_to_hold = false;  // if it is lower than MIS_LTRMIN_ALT (PX4 until 1.13)
  // False: it goes round obstacles, or does not sink as it is told (OA_TYPE, COM_OBS_AVOID,
  // NAV_MIN_GND_DIST).
  bool keeps_to_legs = true;
  bool returns_if_lost = true;  // false: parameters say that no lost link makes it return
  bool lands_below = true;      // false: it lands beside a beacon (PLND_ENABLED)

  // Heights above terrain: ArduPilot's alone.
  double terrain_spacing = 0;  // m between the posts of its terrain: TERRAIN_SPACING
  double terrain_lag = 0;      // m that it may be behind: WPNAV_TER_MARGIN
  // False if TERRAIN_ENABLE or TERRAIN_OFS_MAX is 0, or if a rangefinder is followed.
  bool follows_terrain = true;

  // Whether an item's own radius counts, or the parameter alone.
  bool heeds_item_radius = false;
  // Whether a turn at a passed waypoint is two overlapping S-curves, or begins within the radius.
  bool turns_by_s_curve = false;
  // Whether a return's cone counts as in PX4 1.11, as in 1.12 and later (until 1.15 it may climb to
  // twice the acceptance where that is higher than the return); neither: as ArduPilot's.
  bool cone_of_px4_1_11 = false;
  bool cone_of_px4_1_12 = false;
  bool cone_above_return = false;
  // A leg whose item has a smaller radius than this is not followed, m.
  double least_radius = 0;

  // The airframe's drag over its mass, 1/s; set_drag changes it and what follows from it.
  double drag = 0;

  // Measured.
  Vec3 tracking = Vec3::Zero();  // m from the way along each axis, navigation at its quietest
  double overshoot_time = 0;     // s: a stop is overshot by this times the speed,
  double overshoot = 0;          // m: and by this
  Settling from_stop;            // until that has decayed
  Settling from_corner;          // until a corner has decayed
  double bulge = 0;              // s2/m: while it speeds up behind a corner it leaves the leg to
                                 // either side by this times the square of the speed
  bool climbs_ahead = false;     // on a sloping leg from a rest the height is ahead of the place
  double run_on = 0;             // s: where it waits at a point that it would have passed, it runs
                                 // on by this times the speed
  double fall = 0;               // m that it sinks in a landing until it is above its place
};

// The autopilot on an airframe of that drag over mass, 1/s: the more drag, the further its
// controller overshoots. Those of px4() and ardupilot() have kUsualDrag.
void set_drag(Autopilot& autopilot, double drag);

// The version must be one of those that are modelled (autopilot_words): of PX4 "1.17", of ArduPilot
// Copter "4.7"; without one the union of these.
Autopilot px4(std::string_view version = {});
Autopilot ardupilot(std::string_view version = {});

// "px4", "px4:1.17", "ardupilot", "ardupilot:4.7", or "any": all of them. Nothing for other words.
std::optional<std::vector<Autopilot>> autopilots_of(std::string_view words);
// The words, for a message: "any, px4, px4:1.11 to px4:1.17, …".
std::string autopilot_words();

// "px4:1.11-1.17, ardupilot:4.3-4.7"
std::string names_of(std::span<const Autopilot> autopilots);

// Metres in which an S-curve of the autopilot's acceleration and jerk reaches that speed, m/s:
// v^2 / (2 a) + v a / (2 j).
double s_curve_length(const Autopilot& autopilot, double speed);

}  // namespace traj
