#include "window.h"

#include <cassert>

#include "geom/base/rounding.h"

namespace traj {
namespace {

constexpr double kLeastTime = 1e-9;  // s, that ticks.h takes

// What stands at a point from one time to another.
Trajectory still(const Vec3& at, double duration) {
  Segment segment;
  segment.duration = duration;
  segment.point.fill(at);
  return {{segment}};
}

}  // namespace

Window window_of(const Timeline& line, double begin, double end) {
  assert(begin < end);
  begin = whole_time_below(begin);
  const double duration = std::max(geom::add_up(end, -begin), kLeastTime);
  Window out;
  out.from = line.segments->front().point.front();
  const Trajectory standing = still(out.from, duration);
  const Timeline clock(TimedFlight{&standing, begin, Vec3::Zero()});
  for (const CommonStretch& stretch : stretches(line, clock, Parked::gone)) {
    const RelativeCurve curve = relative_curve(line, clock, stretch);
    const double off = geom::add_up(rounding_after(curve, 0), line.gap);
    out.stretches.push_back({curve, off});
  }
  return out;
}

}  // namespace traj
