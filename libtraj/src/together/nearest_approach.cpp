#include "traj/together/nearest_approach.h"

#include <algorithm>
#include <tuple>

#include "curve/curve_piece.h"
#include "geom/base/parallel.h"
#include "geom/base/precondition.h"
#include "timeline.h"

namespace traj {
namespace {

constexpr double kTolerance = 1e-3;  // metres
constexpr double kLeastBox = 25;     // metres: boxes of the broad phase

// No more than the distance from zero to any point of the curve: to the box around it, or to the
// plane through the control point that is least far along the way to its middle.
double least_distance(const Points<kPoints>& q, const Vec3& middle) {
  const geom::Aabb box = hull_box(q);
  const Vec3 off = box.min.cwiseMax(-box.max).cwiseMax(0.0);
  const double away = middle.norm();
  double along = away;
  for (const Vec3& p : q) along = std::min(along, p.dot(middle) / std::max(away, 1e-300));
  return std::max(off.norm(), along);
}

std::vector<Piece> pieces_between(const Timeline& a, const Timeline& b) {
  std::vector<Piece> pieces;
  for (const CommonStretch& stretch : stretches(a, b, Parked::gone)) {
    if (!stretch.begin || !stretch.end || !stretch.segment || !stretch.other) continue;
    pieces.push_back(
        {relative_curve(a, b, stretch).q, seconds_of(*stretch.begin), seconds_of(*stretch.end)});
  }
  return pieces;
}

std::optional<Approach> approach_of(const TimedFlight& a, const Timeline& a_line,
                                    const Timeline& b_line, double within) {
  Largest best;
  best.value = -within;  // what is farther is of no interest
  const double none = best.value;
  search_largest(
      pieces_between(a_line, b_line), kTolerance,
      [](const Piece& piece, const Vec3& middle) {
        return Estimate{-middle.norm(), -least_distance(piece.q, middle)};
      },
      best);
  if (!(best.value > none)) return std::nullopt;
  Approach approach;
  approach.distance = -best.value;
  approach.time = best.time;
  approach.place = evaluate(*a.trajectory, best.time - a.start).position;
  approach.other = approach.place - best.place;
  return approach;
}

}  // namespace

std::vector<Approach> nearest_approaches(std::span<const TimedFlight> flights, double within,
                                         const geom::Execution& run) {
  geom::require_length("within", within, geom::kLargestCoordinate);
  Spacing spacing;
  spacing.zone = cylinder(within, within);
  const double step = std::max(kLeastBox, 2 * within);
  const std::vector<FlightPair> near = near_pairs(flights, spacing, Parked::gone, run, step);
  std::vector<Timeline> lines;
  for (const TimedFlight& flight : flights) lines.emplace_back(flight);
  std::vector<std::optional<Approach>> found(near.size());
  geom::parallel_for(near.size(), run, [&](std::size_t i) {
    const auto [a, b] = near[i];
    found[i] = approach_of(flights[a], lines[a], lines[b], within);
    if (found[i]) found[i]->flights = near[i];
  });
  std::vector<Approach> out;
  for (const auto& approach : found) {
    if (approach) out.push_back(*approach);
  }
  std::sort(out.begin(), out.end(), [](const Approach& a, const Approach& b) {
    return std::tie(a.distance, a.flights) < std::tie(b.distance, b.flights);
  });
  return out;
}

Approaches nearest_approaches(std::span<const TimedFlight> flights, std::size_t wanted, double most,
                              const geom::Execution& run) {
  Approaches out;
  for (double power = 1; out.within < most; power *= 10) {
    for (const double lead : {1.0, 2.0, 5.0}) {
      out.within = std::min(lead * power, most);
      out.list = nearest_approaches(flights, out.within, run);
      if (out.list.size() >= wanted || out.within >= most) return out;
    }
  }
  return out;
}

}  // namespace traj
