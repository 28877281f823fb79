#include "solve/optimize.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "banded_solve.h"
#include "cruise.h"
#include "curve/portable_math.h"
#include "ipopt_solve.h"
#include "nlp.h"
#include "solve/nominal.h"
#include "solve/time_allocation.h"
#include "traj/solve/min_snap.h"

namespace traj {
namespace {

constexpr double kCornerDeviation = 1;  // metres, in the solver's units
constexpr double kMostJerk = 20;        // m/s3: of the scale of a joint's jerk
constexpr double kUsual = 20;           // metres: shorter paths are counted in smaller units
constexpr int kBandedIterations = 5;    // for each of Ipopt's, which takes ten times as long

std::vector<Vec3> points_of(const Corridor& corridor) {
  std::vector<Vec3> points{corridor.front().from};
  for (const CorridorPiece& piece : corridor) points.push_back(piece.to);
  return points;
}

double length_of(const Corridor& corridor) {
  double sum = 0;
  for (const CorridorPiece& piece : corridor) sum += (piece.to - piece.from).norm();
  return sum;
}

std::vector<SpeedProfile> profiles(const Corridor& corridor, const Limits& limits) {
  const SpeedProfile nominal = nominal_profile(limits, length_of(corridor));
  std::vector<SpeedProfile> out;
  for (const CorridorPiece& piece : corridor) {
    out.push_back(along_leg(piece.to - piece.from, limits, nominal));
  }
  return out;
}

// Velocities at the ends of a part of a corridor.
struct Ends {
  Vec3 first = Vec3::Zero();
  Vec3 last = Vec3::Zero();
};

// The curve of least snap through the joints, rolling at half the acceleration: near enough to
// feasible. (With straight velocities and no acceleration at the joints, close turns took hundreds
// of times what the limits allow.)
void add_guess(std::vector<SpeedProfile> legs, const Ends& ends, NlpSpec& spec) {
  const std::vector<Vec3> points = points_of(spec.corridor);
  for (SpeedProfile& leg : legs) leg.amax /= 2;
  const std::vector<double> speeds = corner_speeds(
      points, legs,
      {legs.front().amax, kCornerDeviation, true, ends.first.norm(), ends.last.norm()});
  spec.time = rolling_times(points, speeds, legs);
  for (const Vec3& p : points) spec.state.push_back({p});
  spec.state.front().velocity = ends.first;
  spec.state.back().velocity = ends.last;
  std::vector<Waypoint> waypoints = waypoints_at(points);
  waypoints.front().velocity = ends.first;
  waypoints.back().velocity = ends.last;
  const Trajectory curve = min_snap(waypoints, spec.time);
  if (curve.segments.size() != spec.time.size()) return;  // lengths lost to rounding
  for (std::size_t i = 1; i < curve.segments.size(); ++i) {
    spec.state[i] = evaluate(curve.segments[i], 0);
    spec.state[i].position = points[i];
  }
}

// What moves a Bernstein point of the shorter neighbour by about a metre, within the limits.
void add_scales(std::span<const SpeedProfile> legs, NlpSpec& spec) {
  const std::size_t n = spec.time.size();
  for (std::size_t i = 0; i <= n; ++i) {
    const std::size_t before = i == 0 ? 0 : i - 1;
    const std::size_t after = std::min(i, n - 1);
    const double t = std::min(spec.time[before], spec.time[after]);
    const SpeedProfile profile{std::min(legs[before].vmax, legs[after].vmax), legs[after].amax};
    spec.scale.push_back(
        {1, std::min(profile.vmax, kDegree / t),
         std::min(profile.amax, kDegree * (kDegree - 1) / (t * t)),
         std::min(kMostJerk, kDegree * (kDegree - 1) * (kDegree - 2) / (t * t * t))});
  }
}

std::vector<QuadraticLimit> quadratic(const Limits& limits) {
  std::vector<QuadraticLimit> out;
  const auto add = [&](int order, const std::optional<double>& limit, const Vec3& axes,
                       const Vec3& shift) {
    if (limit) out.push_back({order, axes / (*limit * *limit), shift, 1});
  };
  const Vec3 gravity(0, 0, kGravity);
  add(1, limits[Limit::speed], Vec3::Ones(), Vec3::Zero());
  add(1, limits[Limit::horizontal_speed], {1, 1, 0}, Vec3::Zero());
  add(1, limits[Limit::vertical_speed], {0, 0, 1}, Vec3::Zero());
  add(2, limits[Limit::acceleration], Vec3::Ones(), Vec3::Zero());
  add(2, limits[Limit::thrust], Vec3::Ones(), gravity);
  add(3, limits[Limit::jerk], Vec3::Ones(), Vec3::Zero());
  if (limits[Limit::tilt]) {
    // (|a_xy| / tan)^2 <= (a_z + g)^2, in units of g: the cone, and its mirror image below, which
    // the start is far from.
    const double tangent = tangent_below(*limits[Limit::tilt]);
    out.push_back(
        {2, Vec3(1 / (tangent * tangent), 1 / (tangent * tangent), -1) / (kGravity * kGravity),
         gravity, 0});
  }
  return out;
}

NlpSpec problem(const Corridor& corridor, const Ends& ends, const OptimizeOptions& options) {
  NlpSpec spec;
  spec.corridor = corridor;
  spec.rho = options.rho;
  const std::vector<SpeedProfile> legs = profiles(corridor, options.limits);
  spec.limits = quadratic(options.limits);
  add_guess(legs, ends, spec);
  add_scales(legs, spec);
  return spec;
}

// What the solver counts in: its tolerances and steps are made for paths of a city. Times go with
// the root of lengths, so accelerations, gravity among them, stay what they are.
struct Units {
  double length = 1;  // metres
  double time = 1;    // seconds
};

Units units_for(const Corridor& corridor) {
  const double length = std::min(1.0, length_of(corridor) / kUsual);
  return {length, std::sqrt(length)};
}

// Numbers stay small, and the same wherever the path lies, when it is counted from here.
Vec3 origin_of(const Corridor& corridor) {
  return 0.5 * (corridor.front().from + corridor.back().to);
}

Corridor in_units(Corridor corridor, const Units& units) {
  const Vec3 o = origin_of(corridor);
  for (CorridorPiece& piece : corridor) {
    for (Plane& plane : piece.planes)
      plane.offset = (plane.offset - plane.normal.dot(o)) / units.length;
    piece.from = (piece.from - o) / units.length;
    piece.to = (piece.to - o) / units.length;
  }
  return corridor;
}

OptimizeOptions in_units(OptimizeOptions options, const Units& units) {
  const double speed = units.length / units.time;
  const auto divide = [](std::optional<double>& limit, double unit) {
    if (limit) *limit /= unit;
  };
  divide(options.limits[Limit::speed], speed);
  divide(options.limits[Limit::horizontal_speed], speed);
  divide(options.limits[Limit::vertical_speed], speed);
  divide(options.limits[Limit::jerk], 1 / units.time);
  return options;  // rho is one of these units: see OptimizeOptions
}

// Back again; the states at the ends exactly what was asked for.
Trajectory in_metres(Trajectory trajectory, const Units& units, const Corridor& given,
                     const Ends& ends) {
  for (Segment& s : trajectory.segments) {
    s.duration *= units.time;
    for (Vec3& p : s.point) p = p * units.length + origin_of(given);
  }
  Segment& first = trajectory.segments.front();
  Segment& last = trajectory.segments.back();
  for (std::size_t i = 0; i < 4; ++i) {
    const double share = static_cast<double>(i) / kDegree;
    first.point[i] = given.front().from + share * first.duration * ends.first;
    last.point[kDegree - i] = given.back().to - share * last.duration * ends.last;
  }
  return trajectory;
}

// What a solver came back with, in metres, as the problem sees it.
template <class Outcome>
OptimizeResult judged(const Nlp& nlp, const Outcome& outcome, const Units& units,
                      const Corridor& given, const Ends& ends) {
  OptimizeResult result;
  result.trajectory = in_metres(nlp.trajectory(outcome.x), units, given, ends);
  result.status = outcome.status;
  result.settled = outcome.settled;
  result.iterations = outcome.iterations;
  result.objective = units.time * nlp.objective(outcome.x);
  const std::vector<double> values = nlp.constraint_values(outcome.x);
  for (std::size_t i = 0; i < values.size(); ++i) {
    result.max_violation = std::max(result.max_violation, values[i] - nlp.bound()[i]);
  }
  return result;
}

OptimizeResult optimize_part(const Corridor& given, const Ends& ends,
                             const OptimizeOptions& asked) {
  assert(given.size() >= 2);
  const Units units = units_for(given);
  const double speed = units.length / units.time;
  const Corridor corridor = in_units(given, units);
  const OptimizeOptions options = in_units(asked, units);
  const Nlp nlp(problem(corridor, {ends.first / speed, ends.last / speed}, options));
  if (options.optimizer == Optimizer::banded) {
    return judged(nlp, banded_solve(nlp, kBandedIterations * options.max_iterations), units, given,
                  ends);
  }
  return judged(nlp, ipopt_solve(nlp, options.max_iterations), units, given, ends);
}

// Flies `part` after what `whole` has already. Its word is that of the first part that did not
// settle, else of the last.
void append(const OptimizeResult& part, OptimizeResult& whole) {
  auto& segments = whole.trajectory.segments;
  segments.insert(segments.end(), part.trajectory.segments.begin(), part.trajectory.segments.end());
  if (whole.settled) whole.status = part.status;
  whole.settled = whole.settled && part.settled;
  whole.iterations = std::max(whole.iterations, part.iterations);
  whole.objective += part.objective;
  whole.max_violation = std::max(whole.max_violation, part.max_violation);
}

}  // namespace

OptimizeResult optimize(const Corridor& given, const OptimizeOptions& options) {
  if (!options.cruise) return optimize_part(given, {}, options);
  const std::vector<CruisePart> all = cruise_parts(given, options.limits, options.rho);
  if (all.size() == 1) return optimize_part(given, {}, options);
  OptimizeResult whole;
  whole.settled = true;
  whole.cruises = true;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto pieces = all[i].of(given);
    if (all[i].cruises()) {
      const Trajectory straight = cruise(pieces, all[i].velocity);
      auto& segments = whole.trajectory.segments;
      segments.insert(segments.end(), straight.segments.begin(), straight.segments.end());
      whole.objective += duration(straight);
      continue;
    }
    Ends ends;
    if (i > 0) ends.first = all[i - 1].velocity;
    if (i + 1 < all.size()) ends.last = all[i + 1].velocity;
    append(optimize_part(Corridor(pieces.begin(), pieces.end()), ends, options), whole);
  }
  assert(whole.trajectory.segments.size() == given.size());
  return whole;
}

}  // namespace traj
