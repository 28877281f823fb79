#pragma once

// How far apart two flights must be.
//
// Example:
//   const traj::Zone zone = traj::cylinder(5, 3);  // 5 m aside, 3 m up and down
//   assert(traj::share_of(zone, {10, 0, 0}) == 2 && traj::depth_in(zone, {4, 0, 0}) == 1);
//   const auto zones = traj::zones_between({.zone = zone}, scene.half(), scene.half());

#include <optional>
#include <string>
#include <vector>

#include "geom/base/error.h"
#include "geom/base/vec3.h"

namespace traj {

using geom::Vec3;

// Differences of position, of reference points, that are a conflict: a closed box around zero of
// half sizes `reach`, or, where it is `round`, the upright cylinder of radius reach.x() = reach.y()
// and half height reach.z(). Each is > 0.
struct Zone {
  bool round = false;
  Vec3 reach = Vec3::Zero();  // metres

  friend bool operator==(const Zone&, const Zone&) = default;
};

Zone cylinder(double across, double up);

// What one of the flights must keep out of around the other, at every instant.
struct Spacing {
  std::optional<Zone> zone;      // the same for all; else the sum of the two rooms, as a box
  std::optional<Zone> downwash;  // beside it: below each of the two, and so above the other
};

// The zones of two flights with these rooms (TimedFlight), each side rounded up.
std::vector<Zone> zones_between(const Spacing& spacing, const Vec3& room, const Vec3& other);

// Half of the larger zone along each axis, and the flight's own room where there is no zone,
// rounded up. If two flights, each grown by its reach, are apart, no zone holds their difference.
Vec3 reach_of(const Spacing& spacing, const Vec3& room);

// Why the spacing is not valid: a reach that is not > 0 or beyond 1e8 m. Nothing if it is
// valid.
std::optional<geom::Fault> spacing_fault(const Zone& zone);

// The nearness of a difference of position in a zone's own norm: below 1 inside, 1 on its surface.
// Rounded.
double share_of(const Zone& zone, const Vec3& difference);

// How deep the difference lies in the zone, metres; < 0 outside. Rounded.
double depth_in(const Zone& zone, const Vec3& difference);

}  // namespace traj
