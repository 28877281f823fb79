#include "traj/proof/sampled_flight.h"

#include <algorithm>
#include <cmath>

namespace traj {
namespace {

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

void take(const Part& part, const CheckResult& result, SampledFlight& out) {
  if (result.clearance && (!out.clearance || result.clearance->value < out.clearance->value)) {
    out.clearance = Extreme{result.clearance->value, part.time(result.clearance->time)};
    out.nearest = part.point(result.clearance->time);
  }
  if (result.ok || out.reason != Reason::none) return;
  out.reason = result.reason;
  out.time = part.time(result.time, result.place);
  out.place = result.place;
  out.box = result.box;
  out.worst = result.worst;
}

void note_gap(double time, const Vec3& place, double seconds, SampledFlight& out) {
  if (out.gap || out.reason != Reason::none) return;
  out.gap = true;
  out.time = time;
  out.place = place;
  out.worst = seconds;
}

}  // namespace

std::string_view verdict(const SampledFlight& flight) {
  if (flight.reason != Reason::none) return name(flight.reason);
  return flight.gap ? "gap" : "sampled";
}

SampledFlight check_sampled(const geom::CollisionScene& scene, std::span<const Vec3> points,
                            std::span<const double> times) {
  SampledFlight out;
  out.duration = times.back() - times.front();
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= points.size(); ++i) {
    const double step = i < points.size() ? times[i] - times[i - 1] : 0;
    out.longest_step = std::max(out.longest_step, step);
    if (i < points.size() && step <= kLongestGap) continue;
    const Part part{points.subspan(begin, i - begin), times.subspan(begin, i - begin)};
    take(part, check_path(scene, part.points), out);
    if (i < points.size()) note_gap(times[i - 1], points[i - 1], step, out);
    begin = i;
  }
  if (out.reason != Reason::none) out.gap = false;
  return out;
}

}  // namespace traj
