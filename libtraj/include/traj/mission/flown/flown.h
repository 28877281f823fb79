#pragma once

// The flight of a vehicle that gets a file: a curve, setpoints, legs, or the regions of a mission.
//
// Example:
//   traj::FlownLegs legs;
//   legs.path = path;
//   legs.ends.takeoff_from = 0;  // from the ground, straight up
//   const traj::Flown flown{legs};
//   assert(traj::begin_of(flown) == path.front() && !traj::mission_of(flown));

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "geom/map/frame.h"
#include "geom/shape/polyline.h"
#include "traj/curve/setpoint.h"
#include "traj/curve/vertical_ends.h"
#include "traj/mission/flown/fence.h"
#include "traj/mission/flown/sweep.h"
#include "traj/proof/check.h"
#include "traj/record/terrain_claim.h"

namespace traj {

// A curve that the vehicle follows by time.
struct FlownCurve {
  Trajectory trajectory;
  std::vector<Stray> stray = {};  // of its segments, from the drone's own rounding; may be empty
};

// Setpoints of a client that goes straight from each to the next, at their times. At least two.
struct FlownSetpoints {
  std::vector<Setpoint> setpoints;
};

// Straight legs with a rest at each point.
struct FlownLegs {
  geom::Polyline path;            // at least one point
  std::vector<double> hold = {};  // s at each point; may be empty
  VerticalEnds ends = {};
  bool lands_below = false;        // on whatever is below the last point
  Vec3 path_stray = Vec3::Zero();  // m that the flight may be from the path, along each axis
  // Of each leg of the path, m up and down that the flight may be from it beside that; may be
  // empty.
  std::vector<double> leg_band = {};
  std::optional<double> speed = {};  // m/s along the legs
  double climb = 0;                  // m/s at most, whatever that speed is; 0: as it is
  double descent = 0;                // likewise
  // Whether these limits hold on legs with a band, too. If not, the vehicle may rise or sink twice
  // as fast there.
  bool climb_holds_in_band = false;
  std::optional<FlightEnvelope> envelope = {};
  double airborne = 0;  // s, for the envelope
};

// The legs of a mission, and the regions beside them in which the vehicle may be anywhere.
struct FlownMission : FlownLegs {
  std::vector<FlightPart> legs;    // the one that leads to each point, and the landing's
  std::vector<Sweep> sweeps;       // at waypoints without a rest, and on curves
  std::vector<Drift> drift;        // where the autopilots may be, the way itself included
  std::vector<Fence> fences;       // that the path and the sweeps keep to
  std::vector<Vec3> rally;         // places in the air from which it may land instead of at home
  std::vector<Vec3> rally_points;  // all of the file, whether or not the mission ends with a return
  std::optional<double> return_height;        // m above home that the file asks for
  std::optional<double> speed_before_return;  // m/s, if only the return's is not known
  std::vector<Vec3> touches;  // places in the air from which it sinks to the ground on its way
  std::optional<Vec3> home;   // as assumed: in the file, or under the first point
  bool ends_at_home = false;  // ends with a return to home, at a height that no file says
  bool counts_from_flat_ground = false;  // a height of it does (MissionRules::ground)
  bool switches_fence = false;           // an item of it switches ArduPilot's fence on
  bool returns = false;                  // ends with a return to home, by a way that is not known
  std::size_t idle_items = 0;            // that move nothing
  std::size_t endless_jumps = 0;         // jumps for ever: their loops are looked at flown twice
  std::size_t corners = 0;               // points between two legs without a rest
  double acceptance = 0;                 // m around these, the most that was swept
  // Of a mission with heights above terrain: each place above is a band of heights, and the
  // vehicle's height in it is not known at any instant.
  std::optional<TerrainClaim> terrain = {};
  double least_seconds = 0;     // that it takes, leg by leg; an estimate. 0: nobody knows
  std::string endless = {};     // why nobody knows how long it takes; empty: that is known
  bool returns_if_lost = true;  // when its link is lost; false where file or parameters say no
};

// How far a vehicle may be from the places that a mission says, along each axis: latitudes and
// longitudes travel as whole 1e-7 degrees, cut or rounded by the ground station, and heights are
// kept to centimetres by some autopilots.
inline const Vec3 kMissionStray{0.0112, 0.0112, 0.01};

// What a vehicle makes of a file, and how far it may be off that.
struct Flown {
  std::variant<FlownCurve, FlownSetpoints, FlownLegs, FlownMission> way;
  // m along each axis that the vehicle may be off all this: how wrong it is about its place, and,
  // if there is no drift, how far it strays in tracking.
  Vec3 navigation = Vec3::Zero();
};

// Metres up and down that the flight may be from a leg of its whole way (whole_way() of judge.h,
// where the ascent is the first), beside what strays from all of the path.
double band_of(const FlownLegs& flown, std::size_t leg);

// Legs, alone or of a mission; null of others. Points into `flown`.
const FlownLegs* legs_of(const Flown& flown);
// The regions beside legs; null where `flown` is no mission.
const FlownMission* mission_of(const Flown& flown);
// Whether the places of autopilots are known, so that tracking is part of them.
bool has_drift(const Flown& flown);

// The way of a client that goes straight from position to position, at these times.
Trajectory straight_between(const std::vector<Setpoint>& setpoints);

// The curve, or the straight ways between setpoints with their times; empty of legs.
Trajectory trajectory_of(const Flown& flown);

// The first place of its way.
Vec3 begin_of(const Flown& flown);

// Between a map's axes and east, north, up, in either direction (geom::to_enu is its own inverse).
Flown to_enu(geom::Axes axes, Flown flown);

}  // namespace traj
