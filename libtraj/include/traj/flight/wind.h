#pragma once

// Wind: a constant part, and Dryden gusts at low altitude after MIL-F-8785C.
//
// Example:
//   traj::Wind wind({.mean = {3, 0, 0}, .gusts = 2}, 7);  // the seed
//   const geom::Vec3 air = wind.step({0, 0, 30}, geom::Vec3::Zero(), 0.01);

#include "traj/flight/noise.h"

namespace traj {

struct WindSpec {
  geom::Vec3 mean = geom::Vec3::Zero();  // m/s, the air's velocity in ENU
  double gusts = 0;  // m/s, >= 0: the wind speed at 20 feet that sets their strength
};

// Deviations (m/s) and scale lengths (m) along the wind, across it and up.
struct DrydenScales {
  geom::Vec3 deviation = geom::Vec3::Zero();
  geom::Vec3 length = geom::Vec3::Ones();
};

// MIL-F-8785C, 3.7.3.4, below 1000 feet; heights are taken as at least 10 and at most 1000 feet.
DrydenScales dryden_scales(double height, double speed_at_20_feet);

// Turbulence frozen in the air and blown past the vehicle: the forming filters of the Dryden
// spectra (first order along the wind, second order across it and up), stepped exactly for white
// noise.
class Gusts {
 public:
  Gusts(double speed_at_20_feet, std::uint64_t seed);

  // The gust after `dt` seconds at `air_speed` (taken as at least 0.5 m/s): along, across, up.
  geom::Vec3 step(double height, double air_speed, double dt);

 private:
  double speed_;
  Gaussian noise_;
  geom::Vec3 first_;  // states of the filters, over their stationary scale
  geom::Vec3 second_;
};

class Wind {
 public:
  Wind(const WindSpec& spec, std::uint64_t seed);

  // The air's velocity in ENU after `dt` seconds where the vehicle is; z is the height above
  // ground.
  geom::Vec3 step(const geom::Vec3& position, const geom::Vec3& velocity, double dt);

 private:
  WindSpec spec_;
  geom::Vec3 along_;  // horizontal, of length 1
  Gusts gusts_;
};

}  // namespace traj
