#pragma once

// The disturbances that a tube is proved for, as members of a record and in words.
//
// Example:
//   const traj::Disturbances windy{.wind = {2, 0, 0}, .wind_spread = 0.2, .gust_most = 0.5};
//   assert(traj::in_words(windy).starts_with("a mean wind within 0.2 m/s of [2, 0, 0] m/s"));

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
  std::string_view share_of = {};  // "a mass", if it is a share of the believed mass; else empty
};
inline constexpr std::array kDisturbanceRanges{
    DisturbanceRange{"wind_spread", &Disturbances::wind_spread, 0, 1e3},
    DisturbanceRange{"gust_most", &Disturbances::gust_most, 0, 1e3},
    DisturbanceRange{"gust_lag", &Disturbances::gust_lag, 1e-6, 1e6},
    DisturbanceRange{"start_error", &Disturbances::start_error, 0, 1e3},
    DisturbanceRange{"start_speed", &Disturbances::start_speed, 0, 1e3},
    DisturbanceRange{"mass_error", &Disturbances::mass_error, 0, 0.5, "a mass"},
    DisturbanceRange{"drag_error", &Disturbances::drag_error, 0, 0.5, "drag"},
    DisturbanceRange{"motor_lag_error", &Disturbances::motor_lag_error, 0, 0.5,
                     "a time constant of the motors"},
    DisturbanceRange{"inertia_error", &Disturbances::inertia_error, 0, 0.5, "inertia"},
    DisturbanceRange{"gain_error", &Disturbances::gain_error, 0, 0.5, "gains"},
    DisturbanceRange{"place_noise", &Disturbances::place_noise, 0, 1e3},
    DisturbanceRange{"velocity_noise", &Disturbances::velocity_noise, 0, 1e3},
    DisturbanceRange{"attitude_noise", &Disturbances::attitude_noise, 0, 1},
    DisturbanceRange{"rate_noise", &Disturbances::rate_noise, 0, 1e3},
};

// Adds the members wind and those of kDisturbanceRanges.
void add(geom::JsonLine& line, const Disturbances& disturbances);

// Throws InputError for a member that is missing or out of range.
Disturbances read_disturbances(const geom::JsonFields& fields);

// "a mean wind within 0.2 m/s of [2, 0, 0] m/s (east, north, up), gusts towards at most 0.5 m/s
// with a lag of 1 s, a mass within 0.5 % of what is believed". Tells every range.
std::string in_words(const Disturbances& disturbances);

}  // namespace traj
