#pragma once

// What may be said beside a drone file, and which formats take heed of it.
//
// Example:
//   constexpr traj::FileOptionSet set{traj::FileOption::ground, traj::FileOption::speed};
//   static_assert(set.has(traj::FileOption::speed) && !set.has(traj::FileOption::rate));

#include <cstddef>
#include <cstdint>
#include <initializer_list>

#include "geom/text/words.h"

namespace traj {

enum class FileOption {
  start,
  takeoff_height,
  heading,
  origin,
  geoid,
  geoid_grid,
  ground,
  return_height,
  terrain,
  ground_model,
  terrain_error,
  surface_band,
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
  lost_link,
  gimbal,
  show,
  volumes,
  buffer,
  returns,
  rally,
  rally_out,
  fence,
  fence_budget,
  fence_out,
  params_out,
  procedure
};
inline constexpr std::size_t kFileOptions = 43;

// As the tools' options name them, without "--".
inline constexpr geom::Words<FileOption, kFileOptions> kFileOptionWords{{
    {FileOption::start, "takeoff-place"},
    {FileOption::takeoff_height, "takeoff-height"},
    {FileOption::heading, "heading"},
    {FileOption::origin, "origin"},
    {FileOption::geoid, "geoid"},
    {FileOption::geoid_grid, "geoid-grid"},
    {FileOption::ground, "ground"},
    {FileOption::return_height, "return-height"},
    {FileOption::terrain, "terrain-height"},
    {FileOption::ground_model, "ground-model"},
    {FileOption::terrain_error, "terrain-error"},
    {FileOption::surface_band, "surface-band"},
    {FileOption::acceptance, "acceptance"},
    {FileOption::braking, "braking"},
    {FileOption::autopilot, "autopilot"},
    {FileOption::params, "params"},
    {FileOption::drag, "drag"},
    {FileOption::navigation, "navigation"},
    {FileOption::tracking, "tracking"},
    {FileOption::gap, "gap"},
    {FileOption::rate, "rate"},
    {FileOption::axes, "axes"},
    {FileOption::tolerance, "tolerance"},
    {FileOption::speed, "speed"},
    {FileOption::hover, "hover"},
    {FileOption::python, "python"},
    {FileOption::table, "table"},
    {FileOption::wpml_version, "wpml-version"},
    {FileOption::aircraft, "aircraft"},
    {FileOption::turns, "turns"},
    {FileOption::lost_link, "lost-link"},
    {FileOption::gimbal, "gimbal"},
    {FileOption::show, "show"},
    {FileOption::volumes, "volumes"},
    {FileOption::buffer, "buffer"},
    {FileOption::returns, "return"},
    {FileOption::rally, "rally"},
    {FileOption::rally_out, "rally-out"},
    {FileOption::fence, "fence"},
    {FileOption::fence_budget, "fence-budget"},
    {FileOption::fence_out, "fence-out"},
    {FileOption::params_out, "params-out"},
    {FileOption::procedure, "procedure"},
}};

// A set of them.
class FileOptionSet {
 public:
  constexpr FileOptionSet() = default;
  constexpr FileOptionSet(std::initializer_list<FileOption> options) {
    for (const FileOption one : options) bits_ |= bit(one);
  }
  constexpr FileOptionSet with(FileOptionSet others) const {
    others.bits_ |= bits_;
    return others;
  }
  constexpr bool has(FileOption option) const { return (bits_ & bit(option)) != 0; }

 private:
  static constexpr std::uint64_t bit(FileOption option) {
    return std::uint64_t{1} << static_cast<int>(option);
  }
  std::uint64_t bits_ = 0;
};

}  // namespace traj
