#pragma once

// The disturbances that a tube is proved for, as members of a record and in words.
//
// Example:
//   geom::JsonLine line;
//   add(line, traj::Disturbances{.wind_spread = 0.2, .gust_most = 0.5});
//   const geom::JsonFields fields(line.object(), "tube.jsonl", 1);
//   assert(traj::read_disturbances(fields).gust_most == 0.5);

#include <array>
#include <string>
#include <string_view>

#include "traj/tube/prove_tube.h"

namespace geom {
class JsonFields;
class JsonLine;
}  // namespace geom

namespace traj {

// A range that is one number: the member of records, where it is kept, and what it may be.
struct DisturbanceRange {
  std::string_view key;
  double Disturbances::*value;
  double least = 0;  // closed
  double most = 0;
};
inline constexpr std::array kDisturbanceRanges{
    DisturbanceRange{"wind_spread", &Disturbances::wind_spread, 0, 1e3},
    DisturbanceRange{"gust_most", &Disturbances::gust_most, 0, 1e3},
    DisturbanceRange{"gust_lag", &Disturbances::gust_lag, 1e-6, 1e6},
    DisturbanceRange{"mass_error", &Disturbances::mass_error, 0, 0.5},
    DisturbanceRange{"drag_error", &Disturbances::drag_error, 0, 0.5},
    DisturbanceRange{"motor_lag_error", &Disturbances::motor_lag_error, 0, 0.5},
    DisturbanceRange{"inertia_error", &Disturbances::inertia_error, 0, 0.5},
};

// Adds the members wind and those of kDisturbanceRanges.
void add(geom::JsonLine& line, const Disturbances& disturbances);

// Throws InputError for a member that is missing or out of range.
Disturbances read_disturbances(const geom::JsonFields& fields);

// "a mean wind within 0.2 m/s of [2, 0, 0] m/s (east, north, up), gusts towards at most 0.5 m/s
// with a lag of 1 s, a mass within 0.5 % of what is believed".
std::string in_words(const Disturbances& disturbances);

}  // namespace traj
