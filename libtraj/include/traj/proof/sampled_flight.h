#pragma once

// How close a flight came to a map that is known by samples alone.
//
// Example:
//   const std::vector<geom::Vec3> points = {{1, 1, 1}, {1, 2, 1}, {1, 3, 1}};
//   const std::vector<double> times = {0, 0.5, 1};
//   const traj::SampledFlight flight = traj::check_sampled(scene, points, times);
//   assert(traj::verdict(flight) == "sampled");  // never more than that
//
// This is no proof, as nobody knows what the flight did between them.

#include <optional>
#include <span>
#include <string_view>

#include "geom/collision/collision.h"
#include "traj/proof/check.h"

namespace traj {

inline constexpr double kLongestGap = 1;  // s between two samples; with a longer one it is refused
// m and m/s: a vehicle does not fly further than both allow between two samples.
inline constexpr double kLongestJump = 1;
inline constexpr double kFastestFlight = 100;

struct SampledFlight {
  Reason reason = Reason::none;  // where it left the bounds, or touched an obstacle
  bool gap = false;              // without such a place: where too much of it is not known
  double time = 0;               // s: of that place, or of the sample before the gap
  Vec3 place = Vec3::Zero();
  std::optional<std::size_t> box;  // the obstacle: an index into BoxMap::boxes()
  double worst = 0;                // m, or s of a gap

  // Metres to the obstacles grown by the vehicle without its margin, the least, and where that was.
  // Absent without obstacles.
  std::optional<Extreme> clearance;
  Vec3 nearest = Vec3::Zero();
  double duration = 0;      // s from the first sample to the last
  double on_ground = 0;     // s of it that the vehicle stood, before and after
  double longest_step = 0;  // s between two samples
};

// "sampled" at best, and never more: a touch ("collision", else "bounds"), else "gap".
std::string_view verdict(const SampledFlight& flight);

// Along the straight lines between neighbouring samples, exact on these (check_path), but for those
// that are more than kLongestGap apart, or further than a vehicle flies. `points` in the map's
// axes, reached at `times`, which grow; at least one. Throws InputError for other spans.
//
// A log may begin and end on the ground: while a vehicle is within 2 m across of its first sample,
// or its last, and not half a metre above where it would be clear, what lies below it is stood on,
// and neither it nor the floor counts as a touch. Heights may be half a metre wrong there.
SampledFlight check_sampled(const geom::CollisionScene& scene, std::span<const Vec3> points,
                            std::span<const double> times);

}  // namespace traj
