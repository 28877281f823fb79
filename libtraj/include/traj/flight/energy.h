#pragma once

// What a vehicle's battery holds, and what flying takes of it at most.
//
// Example:
//   const traj::Energy energy{.capacity = 74 * 3600, .power = 250, .reserve = 0.2};
//   assert(traj::flying_time(energy) == 74 * 3600 * 0.8 / 250);

namespace traj {

struct Energy {
  double capacity = 0;  // J, > 0
  double power = 0;     // W, > 0: the most that hovering, cruising or climbing takes
  double reserve = 0;   // the share of the capacity that stays in the battery, 0 to below 1
  double wind = 0;      // m/s at most, from any direction
};

// Seconds in the air until only the reserve is left, at the largest power all the time.
constexpr double flying_time(const Energy& energy) {
  return energy.capacity * (1 - energy.reserve) / energy.power;
}

}  // namespace traj
