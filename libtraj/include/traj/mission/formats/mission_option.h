#pragma once

// What may be said beside a drone file, and which formats take heed of it.
//
// Example:
//   constexpr traj::MissionOptionSet set{traj::MissionOption::ground, traj::MissionOption::speed};
//   static_assert(set.has(traj::MissionOption::speed) && !set.has(traj::MissionOption::rate));

#include <cstddef>
#include <initializer_list>

#include "geom/text/words.h"

namespace traj {

enum class MissionOption {
  start,
  takeoff_height,
  heading,
  origin,
  geoid,
  ground,
  return_height,
  terrain,
  acceptance,
  braking,
  autopilot,
  params,
  drag,
  navigation,
  tracking,
  gap,
  rate,
  axes,
  tolerance,
  speed,
  hover,
  python,
  table,
  wpml_version,
  aircraft,
  turns,
  show,
  volumes,
  buffer
};
inline constexpr std::size_t kMissionOptions = 29;

// As the tools' options name them, without "--".
inline constexpr geom::Words<MissionOption, kMissionOptions> kMissionOptionWords{{
    {MissionOption::start, "start"},
    {MissionOption::takeoff_height, "takeoff-height"},
    {MissionOption::heading, "heading"},
    {MissionOption::origin, "origin"},
    {MissionOption::geoid, "geoid"},
    {MissionOption::ground, "ground"},
    {MissionOption::return_height, "return-height"},
    {MissionOption::terrain, "terrain"},
    {MissionOption::acceptance, "acceptance"},
    {MissionOption::braking, "braking"},
    {MissionOption::autopilot, "autopilot"},
    {MissionOption::params, "params"},
    {MissionOption::drag, "drag"},
    {MissionOption::navigation, "navigation"},
    {MissionOption::tracking, "tracking"},
    {MissionOption::gap, "gap"},
    {MissionOption::rate, "rate"},
    {MissionOption::axes, "axes"},
    {MissionOption::tolerance, "tolerance"},
    {MissionOption::speed, "speed"},
    {MissionOption::hover, "hover"},
    {MissionOption::python, "python"},
    {MissionOption::table, "table"},
    {MissionOption::wpml_version, "wpml-version"},
    {MissionOption::aircraft, "aircraft"},
    {MissionOption::turns, "turns"},
    {MissionOption::show, "show"},
    {MissionOption::volumes, "volumes"},
    {MissionOption::buffer, "buffer"},
}};

// A set of them.
class MissionOptionSet {
 public:
  constexpr MissionOptionSet() = default;
  constexpr MissionOptionSet(std::initializer_list<MissionOption> options) {
    for (const MissionOption one : options) bits_ |= bit(one);
  }
  constexpr bool has(MissionOption option) const { return (bits_ & bit(option)) != 0; }

 private:
  static constexpr unsigned bit(MissionOption option) { return 1u << static_cast<int>(option); }
  unsigned bits_ = 0;
};

}  // namespace traj
