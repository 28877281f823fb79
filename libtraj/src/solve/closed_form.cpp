#include "traj/solve/closed_form.h"

#include <algorithm>

#include "solve/nominal.h"
#include "solve/time_allocation.h"
#include "solve/time_scaling.h"

namespace traj {
namespace {

constexpr double kShareOfSpeed = 1.0 / 5;  // of distance
constexpr double kRestToRest = 16.0 / 35;  // mean over peak speed of a leg from rest to rest
constexpr double kLeast = 0.25;            // of cautious
constexpr double kCornerDeviation = 0.5;   // metres, of trapezoid
constexpr int kRounds = 30;                // with given velocities
constexpr double kCloseEnough = 0.99;      // factors from here to 1 end the rounds

double length(std::span<const Vec3> points) {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += (points[i] - points[i - 1]).norm();
  return sum;
}

// Metres from the leg to the nearest grown obstacle or bound; `reach` where both are further away.
double clearance(const geom::CollisionScene& scene, const Vec3& a, const Vec3& b, double reach) {
  double least = reach;
  const auto planes = scene.separating_planes(a, b, reach);
  if (!planes.empty()) least = std::min(least, planes.front().separation.gap);
  if (const auto& bounds = scene.free_bounds()) {
    for (const Vec3& p : {a, b}) {
      least = std::min({least, (p - bounds->min).minCoeff(), (bounds->max - p).minCoeff()});
    }
  }
  return std::max(0.0, least);
}

std::vector<double> cautious(const geom::CollisionScene& scene, std::span<const Vec3> points,
                             const SpeedProfile& profile) {
  Caution caution;
  caution.cruise = kRestToRest * profile.vmax;
  caution.amax = profile.amax;
  caution.comfortable = profile.vmax * profile.vmax / (2 * profile.amax);
  caution.least = kLeast;
  std::vector<double> clearances;
  for (std::size_t i = 1; i < points.size(); ++i) {
    clearances.push_back(clearance(scene, points[i - 1], points[i], caution.comfortable));
  }
  return cautious_times(points, clearances, caution);
}

std::vector<Vec3> positions(std::span<const Waypoint> waypoints) {
  std::vector<Vec3> points;
  for (const Waypoint& w : waypoints) points.push_back(w.position);
  return points;
}

// Given velocities do not slow down with the curve, so the factor has to be searched for.
std::optional<Trajectory> with_velocities(std::span<const Waypoint> waypoints,
                                          std::vector<double> times, const Limits& limits,
                                          double least_factor) {
  std::optional<Trajectory> best;
  for (int round = 0; round < kRounds; ++round) {
    const Trajectory curve = min_snap(waypoints, times);
    const double factor = smallest_factor(curve, limits);
    if (factor <= 1 && (!best || duration(curve) < duration(*best))) best = curve;
    if (factor <= 1 && std::max(factor, least_factor) >= kCloseEnough) break;
    for (double& t : times) t *= factor > 1 ? factor / kCloseEnough : factor;
  }
  return best;
}

}  // namespace

std::vector<double> leg_times(const geom::CollisionScene& scene, std::span<const Vec3> points,
                              const Limits& limits, Times times) {
  if (points.empty()) return {};
  const SpeedProfile profile = nominal_profile(limits, length(points));
  switch (times) {
    case Times::distance:
      return even_times(points, profile.vmax * kShareOfSpeed);
    case Times::cautious:
      return cautious(scene, points, profile);
    case Times::trapezoid: {
      const std::vector<SpeedProfile> gentle(points.size() - 1, {profile.vmax, profile.amax / 2});
      return rolling_times(points, corner_speeds(points, gentle, {profile.amax, kCornerDeviation}),
                           gentle);
    }
    case Times::stops:
      break;
  }
  return stopping_times(points, profile);
}

std::optional<Trajectory> closed_form(const geom::CollisionScene& scene,
                                      std::span<const Waypoint> waypoints, const Limits& limits,
                                      Times times) {
  const std::vector<Vec3> points = positions(waypoints);
  const std::vector<double> seconds = leg_times(scene, points, limits, times);
  std::vector<Waypoint> passed = waypoints_at(points);
  bool given = false;
  for (std::size_t i = 0; i < passed.size(); ++i) {
    passed[i].velocity = waypoints[i].velocity;
    given = given || passed[i].velocity;
  }
  const bool only_slower = times == Times::distance || times == Times::cautious;
  const double least_factor = only_slower ? 1 : 0;
  if (given) return with_velocities(passed, seconds, limits, least_factor);
  const Trajectory curve = min_snap(passed, seconds);
  return slowed(curve, std::max(smallest_factor(curve, limits), least_factor));
}

}  // namespace traj
