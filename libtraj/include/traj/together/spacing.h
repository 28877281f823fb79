#pragma once

// How far apart two flights must be.
//
// Example:
//   const traj::Zone zone = traj::cylinder(5, 3);  // 5 m aside, 3 m up and down
//   assert(traj::share_of(zone, {10, 0, 0}) == 2 && traj::depth_in(zone, {4, 0, 0}) == 1);
//   const auto zones = traj::zones_between({.zone = zone}, scene.half(), scene.half());

#include <array>
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

// Vehicles that a zone is to keep apart. Two flights that keep out of a zone which is smaller than
// their vehicles may touch, so such a zone proves nothing.
class VehiclesInZone {
 public:
  // Without a zone there is nothing to refuse: the distance follows from the vehicles.
  explicit VehiclesInZone(const std::optional<Zone>& zone = {}) : zone_(zone) {}

  // `half`: of the vehicle of this flight, without a margin. Throws UsageError where it and one
  // that was added before touch outside of the zone, beside or above each other.
  void add(const std::string& id, const Vec3& half);

 private:
  struct Largest {
    double half = 0;
    std::string id;  // empty: none was added
  };

  std::optional<Zone> zone_;
  std::array<Largest, 3> largest_;  // along each axis
};

// The nearness of a difference of position in a zone's own norm: below 1 inside, 1 on its surface.
// Rounded.
double share_of(const Zone& zone, const Vec3& difference);

// How deep the difference lies in the zone, metres; < 0 outside. Rounded.
double depth_in(const Zone& zone, const Vec3& difference);

}  // namespace traj
