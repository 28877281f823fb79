#include "traj/airspace/held.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geom/base/rounding.h"
#include "geom/record/instant.h"
#include "window.h"

namespace traj {
namespace {

using geom::Vec2;

constexpr int kDeepest = 40;
constexpr double kLatest = 2e9;     // s: later than any arrival, and so earlier than any departure
constexpr double kRounding = 1e-6;  // m: far more than projecting and the sums here round by

// What a reference point must be within, for the room around it to be within a volume.
class Inside {
 public:
  Inside(const geom::Volume4d& volume, const FlightOnEarth& flight, std::string_view source) {
    const geom::MapOutline outline = geom::outline_on_map(
        volume.outline, flight.origin, geom::CircleSide::within, "a volume", source);
    const Vec3& room = flight.flight.room;
    const double turn = area_of(outline.ring) < 0 ? -1 : 1;
    for (std::size_t i = 0; i < outline.ring.size(); ++i) {
      const Vec2& a = outline.ring[i];
      const Vec2 way = outline.ring[(i + 1) % outline.ring.size()] - a;
      const Vec2 out = turn * Vec2(way.y(), -way.x()) / way.norm();
      const double reach = std::abs(out.x()) * room.x() + std::abs(out.y()) * room.y();
      sides_.push_back({out, a, reach + outline.bulge + kRounding});
    }
    bottom_ = *volume.lower - flight.origin.height + room.z() + kRounding;
    top_ = *volume.upper - flight.origin.height - room.z() - kRounding;
  }

  // All that is within `off` of `p` along each axis. A point on the inner side of all edges of a
  // simple polygon, convex or not, is in it.
  bool holds(const Vec3& p, double off) const {
    if (!(p.z() - off >= bottom_ && p.z() + off <= top_)) return false;
    return std::all_of(sides_.begin(), sides_.end(), [&](const Side& side) {
      return side.out.dot(p.head<2>() - side.at) + side.reach + off * side.out.lpNorm<1>() <= 0;
    });
  }

 private:
  struct Side {
    Vec2 out;  // a normal
    Vec2 at;
    double reach;  // m that the point must stay away
  };

  static double area_of(const std::vector<Vec2>& ring) {
    double area = 0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      const Vec2 a = ring[i] - ring[0];
      const Vec2 b = ring[i + 1] - ring[0];
      area += a.x() * b.y() - a.y() * b.x();
    }
    return area;
  }

  std::vector<Side> sides_;
  double bottom_ = 0;
  double top_ = 0;
};

// Points relative to `from`.
bool holds_curve(const Inside& inside, const Vec3& from, const Points<kPoints>& q, double off,
                 int depth) {
  const auto holds = [&](const Vec3& p) { return inside.holds(from + p, off); };
  if (std::all_of(q.begin(), q.end(), holds)) return true;
  if (depth == kDeepest || !holds(q.front()) || !holds(q.back())) return false;
  const auto [left, right] = halves(q);
  return holds_curve(inside, from, left, off, depth + 1) &&
         holds_curve(inside, from, right, off, depth + 1);
}

std::optional<std::string> why_no_cover(const FlightOnEarth& flight, Ticks end,
                                        std::span<const geom::Volume4d> volumes) {
  for (const geom::Volume4d& v : volumes) {
    if (!v.lower || !v.upper || !v.start || !v.end) {
      return "a volume has no lower or upper altitude, no begin or no end";
    }
  }
  if (volumes.empty()) return "there is no volume";
  if (geom::seconds_between(flight.epoch, *volumes.front().start).most > flight.flight.start) {
    return fmt::format("the first volume begins after the departure, at {}",
                       *volumes.front().start);
  }
  for (std::size_t i = 1; i < volumes.size(); ++i) {
    if (geom::seconds_between(*volumes[i - 1].end, *volumes[i].start).most > 0) {
      return fmt::format("no volume holds from {} to {}", *volumes[i - 1].end, *volumes[i].start);
    }
  }
  const double last = geom::seconds_between(flight.epoch, *volumes.back().end).least;
  if (ticks_of(whole_time_below(std::clamp(last, -kLatest, kLatest))) < end) {
    return fmt::format("the last volume ends before the arrival, at {}", *volumes.back().end);
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> why_not_held(const FlightOnEarth& flight,
                                        std::span<const geom::Volume4d> volumes,
                                        std::string_view source) {
  const Timeline line(flight.flight);
  if (auto why = why_no_cover(flight, line.joint.back(), volumes)) return why;
  for (std::size_t i = 0; i < volumes.size(); ++i) {
    const Inside inside(volumes[i], flight, source);
    const double begin = geom::seconds_between(flight.epoch, *volumes[i].start).least;
    const double end = geom::seconds_between(flight.epoch, *volumes[i].end).most;
    if (begin >= kLatest || end <= -kLatest) continue;  // nothing flies then
    const Window window = window_of(line, std::max(begin, -kLatest), std::min(end, kLatest));
    for (const Window::Stretch& stretch : window.stretches) {
      const double off = geom::add_up(rounding_after(stretch.curve, kDeepest), stretch.off);
      if (holds_curve(inside, window.from, stretch.curve.q, off, 0)) continue;
      return fmt::format("volume {} does not hold the vehicle at all times from {} to {}", i,
                         *volumes[i].start, *volumes[i].end);
    }
  }
  return std::nullopt;
}

}  // namespace traj
