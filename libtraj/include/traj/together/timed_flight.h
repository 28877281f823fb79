#pragma once

// A trajectory at its time, among others.
//
// Example:
//   traj::TimedFlight flight{.trajectory = &trajectory, .start = 60};  // seconds after the epoch
//   flight.room = scene.half();

#include "geom/text/words.h"
#include "traj/curve/trajectory.h"

namespace traj {

struct TimedFlight {
  const Trajectory* trajectory = nullptr;  // within domain.h; must outlive this
  double start = 0;                        // seconds after the epoch: 0, or within FlightTime's
  Vec3 room = Vec3::Zero();                // half sizes with the margin, metres, >= 0
};

// What a flight is before its departure and after its arrival: at rest at its first and its last
// point, for all time; or not there. At the two instants themselves it is there.
enum class Parked { pad, gone };
inline constexpr geom::Words<Parked, 2> kParkedWords{{
    {Parked::pad, "pad"},
    {Parked::gone, "gone"},
}};
constexpr std::string_view name(Parked parked) { return geom::word_of(kParkedWords, parked); }

}  // namespace traj
