#include "traj/proof/sampled_flight.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "geom/base/error.h"
#include "geom/shape/hull.h"

namespace traj {
namespace {

using geom::Aabb;

// A run of samples without a gap.
struct Part {
  std::span<const Vec3> points;
  std::span<const double> times;

  std::size_t leg(double at) const {
    return std::min(static_cast<std::size_t>(std::max(at, 0.0)),
                    times.size() < 2 ? 0 : times.size() - 2);
  }
  // When and where the way is at a time that counts legs.
  double time(double at) const {
    const std::size_t i = leg(at);
    if (times.size() < 2) return times[0];
    return times[i] + (at - static_cast<double>(i)) * (times[i + 1] - times[i]);
  }
  // When it is there, on the leg of such a time. How a check's time runs along a leg is its own
  // affair.
  double time(double at, const Vec3& place) const {
    const std::size_t i = leg(at);
    if (times.size() < 2) return times[0];
    const Vec3 way = points[i + 1] - points[i];
    const double square = way.squaredNorm();
    const double share =
        square > 0 ? std::clamp((place - points[i]).dot(way) / square, 0.0, 1.0) : 0;
    return times[i] + share * (times[i + 1] - times[i]);
  }
  Vec3 point(double at) const {
    const std::size_t i = leg(at);
    if (times.size() < 2) return points[0];
    return points[i] + (at - static_cast<double>(i)) * (points[i + 1] - points[i]);
  }
};

constexpr double kHeightError = 0.5;  // m, of a log on the ground
constexpr double kOnTheSpot = 2;      // m across

// Whether what stands at a place may stand on the box: it is below, and not half a metre above.
bool carries(const Aabb& box, const Vec3& spot) {
  return spot.x() >= box.min.x() && spot.x() <= box.max.x() && spot.y() >= box.min.y() &&
         spot.y() <= box.max.y() && box.max.z() <= spot.z() + kHeightError;
}

// Whether the vehicle stands there: on the floor or on an obstacle below it.
bool touches_ground(const geom::CollisionScene& scene, const Vec3& p) {
  const double floor = scene.map().spec().bounds.min.z();
  if (p.z() < floor - kHeightError) return false;
  if (p.z() < floor + scene.half().z()) return true;
  const auto touched = scene.boxes_meeting({p, p});
  return std::any_of(touched.begin(), touched.end(),
                     [&](std::size_t i) { return carries(scene.map().box(i), p); });
}

bool on_the_spot(const geom::CollisionScene& scene, const Vec3& spot, const Vec3& p) {
  return (p - spot).head<2>().norm() <= kOnTheSpot &&
         std::abs(p.z() - spot.z()) <= scene.half().z() + kHeightError;
}

// Which samples are of a vehicle that stands: those before the first index, and from the second on.
std::pair<std::size_t, std::size_t> in_the_air(const geom::CollisionScene& scene,
                                               std::span<const Vec3> points) {
  std::size_t begin = 0;
  std::size_t end = points.size();
  if (touches_ground(scene, points.front())) {
    while (begin < end && on_the_spot(scene, points.front(), points[begin])) ++begin;
  }
  if (touches_ground(scene, points.back())) {
    while (end > begin && on_the_spot(scene, points.back(), points[end - 1])) --end;
  }
  return {begin, end};
}

// The deepest that a way goes into obstacles, but for those that carry a vehicle at the spot.
CheckResult deepest_touch(const geom::CollisionScene& scene, std::span<const Vec3> points,
                          std::optional<Vec3> spot) {
  CheckResult out;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::array<Vec3, 2> leg{points[i], points[std::min(i + 1, points.size() - 1)]};
    if (!scene.hits(leg[0], leg[1])) continue;
    for (const std::size_t box : scene.boxes_meeting(*geom::bounds(std::span<const Vec3>(leg)))) {
      if (spot && carries(scene.map().box(box), *spot)) continue;
      if (!geom::hull_meets(leg, scene.grown(box))) continue;
      const geom::HullDepth depth = geom::hull_depth(leg, scene.grown(box));
      if (out.reason != Reason::none && depth.depth <= out.worst) continue;
      out.reason = Reason::collision;
      out.time = static_cast<double>(i);
      out.place = depth.place;
      out.worst = depth.depth;
      out.box = box;
    }
  }
  return out;
}

// A collision goes before the bounds, and the first of a kind before later ones.
void note_touch(const Part& part, const CheckResult& result, SampledFlight& out) {
  const bool worse = out.reason == Reason::none ||
                     (out.reason == Reason::bounds && result.reason == Reason::collision);
  if (result.reason == Reason::none || !worse) return;
  out.reason = result.reason;
  out.time = part.time(result.time, result.place);
  out.place = result.place;
  out.box = result.box;
  out.worst = result.worst;
}

void take(const geom::CollisionScene& scene, const Part& part, SampledFlight& out) {
  const CheckResult result = check_path(scene, part.points);
  if (result.clearance && (!out.clearance || result.clearance->value < out.clearance->value)) {
    out.clearance = Extreme{result.clearance->value, part.time(result.clearance->time)};
    out.nearest = part.point(result.clearance->time);
  }
  if (result.reason == Reason::bounds) {
    note_touch(part, deepest_touch(scene, part.points, {}), out);
  }
  note_touch(part, result, out);
}

void take_standing(const geom::CollisionScene& scene, const Part& part, const Vec3& spot,
                   SampledFlight& out) {
  note_touch(part, deepest_touch(scene, part.points, spot), out);
  out.on_ground += part.times.back() - part.times.front();
}

// A step of the log, and not of the vehicle: a correction of its place.
bool jumps(const Vec3& from, const Vec3& to, double seconds) {
  return (to - from).norm() > kLongestJump + kFastestFlight * seconds;
}

void note_gap(double time, const Vec3& place, double seconds, SampledFlight& out) {
  if (out.gap || out.reason != Reason::none) return;
  out.gap = true;
  out.time = time;
  out.place = place;
  out.worst = seconds;
}

void require_samples(std::span<const Vec3> points, std::span<const double> times) {
  if (points.empty() || points.size() != times.size()) {
    throw geom::InputError("samples",
                           {.expected = "points, at least one, with a time each",
                            .found = fmt::format("{} with {} times", points.size(), times.size())});
  }
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (std::isfinite(times[i]) && (i == 0 || times[i] > times[i - 1])) continue;
    throw geom::InputError("samples", {.expected = "times that grow",
                                       .found = fmt::format("{} s at sample {}", times[i], i)});
  }
}

}  // namespace

std::string_view verdict(const SampledFlight& flight) {
  if (flight.reason != Reason::none) return name(flight.reason);
  return flight.gap ? "gap" : "sampled";
}

SampledFlight check_sampled(const geom::CollisionScene& scene, std::span<const Vec3> points,
                            std::span<const double> times) {
  require_samples(points, times);
  SampledFlight out;
  out.duration = times.back() - times.front();
  const auto [first, last] = in_the_air(scene, points);
  const auto piece = [&](std::size_t begin, std::size_t end) {
    return Part{points.subspan(begin, end - begin), times.subspan(begin, end - begin)};
  };
  const std::size_t n = points.size();
  if (first > 0) take_standing(scene, piece(0, std::min(first + 1, n)), points.front(), out);
  std::size_t begin = first;
  for (std::size_t i = 1; i <= points.size(); ++i) {
    const double step = i < points.size() ? times[i] - times[i - 1] : 0;
    out.longest_step = std::max(out.longest_step, step);
    const bool gap = step > kLongestGap || (i < n && jumps(points[i - 1], points[i], step));
    if (i < points.size() && gap) note_gap(times[i - 1], points[i - 1], step, out);
    if (i <= begin || (i < last && !gap) || i > last) continue;
    take(scene, piece(begin, i), out);
    begin = i;
  }
  if (last < n) take_standing(scene, piece(last > 0 ? last - 1 : 0, n), points.back(), out);
  if (out.reason != Reason::none) out.gap = false;
  return out;
}

}  // namespace traj
