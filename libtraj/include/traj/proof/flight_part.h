#pragma once

// Pieces of a flight, by what asks for them.
//
// Example:
//   const traj::FlightPart part{.item = 3, .manoeuvre = traj::Manoeuvre::landing};
//   assert(traj::name(part.manoeuvre) == "landing");

#include <cstddef>
#include <string_view>

#include "geom/text/words.h"

namespace traj {

enum class Manoeuvre {
  takeoff,
  leg,
  corner,
  circle,
  hover,
  spline,
  climb,
  return_home,
  landing,
  overshoot  // beyond a stop
};
inline constexpr geom::Words<Manoeuvre, 10> kManoeuvreWords{{
    {Manoeuvre::takeoff, "takeoff"},
    {Manoeuvre::leg, "leg"},
    {Manoeuvre::corner, "corner"},
    {Manoeuvre::circle, "circle"},
    {Manoeuvre::hover, "hover"},
    {Manoeuvre::spline, "spline"},
    {Manoeuvre::climb, "climb"},
    {Manoeuvre::return_home, "return"},
    {Manoeuvre::landing, "landing"},
    {Manoeuvre::overshoot, "overshoot"},
}};
constexpr std::string_view name(Manoeuvre manoeuvre) {
  return geom::word_of(kManoeuvreWords, manoeuvre);
}

struct FlightPart {
  std::size_t item = 0;  // of a mission, as its file counts
  Manoeuvre manoeuvre = Manoeuvre::leg;

  friend bool operator==(const FlightPart&, const FlightPart&) = default;
};

}  // namespace traj
