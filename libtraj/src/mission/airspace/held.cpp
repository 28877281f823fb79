#include "traj/mission/airspace/held.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geom/base/rounding.h"
#include "geom/text/instant.h"
#include "window.h"

namespace traj {
namespace {

using geom::Vec2;

constexpr int kDeepest = 40;
constexpr double kLatest = 2e9;     // s: later than any arrival, and so earlier than any departure
constexpr double kRounding = 1e-6;  // m: far more than projecting and the sums here round by

// What the reference point must be within, for the room around it to be within a volume.
class Inside {
 public:
  Inside(const geom::Volume4d& volume, const FlightOnEarth& flight, std::string_view source) {
    const geom::MapOutline outline = geom::outline_on_map(
        volume.outline, flight.origin, geom::CircleSide::within, "a volume", source);
    polygon_.outer = outline.ring;
    const Vec3& room = flight.flight.room;
    const double turn = area_of(outline.ring) < 0 ? -1 : 1;
    for (std::size_t i = 0; i < outline.ring.size(); ++i) {
      const Vec2& a = outline.ring[i];
      const Vec2& b = outline.ring[(i + 1) % outline.ring.size()];
      const Vec2 out = turn * Vec2((b - a).y(), -(b - a).x()) / (b - a).norm();
      const double reach = std::abs(out.x()) * room.x() + std::abs(out.y()) * room.y();
      edges_.push_back({a, b, out, reach + outline.bulge + kRounding});
    }
    bottom_ = *volume.lower - flight.origin.height + room.z() + kRounding;
    top_ = *volume.upper - flight.origin.height - room.z() - kRounding;
  }

  // The convex hull of the points, and all that is within `off` of it along each axis: one point is
  // inside, and from each edge a plane keeps all of them away. That is across an edge itself or,
  // where that is so short that rounding has turned it, across another.
  bool holds(std::span<const Vec3> points, double off) const {
    for (const Vec3& p : points) {
      if (!(p.z() - off >= bottom_ && p.z() + off <= top_)) return false;
    }
    std::vector<double> furthest;  // of the points along each normal, with their room
    for (const Edge& edge : edges_) {
      double most = -kInfinity;
      for (const Vec3& p : points) most = std::max(most, edge.out.dot(p.head<2>()));
      furthest.push_back(most + edge.reach + off * edge.out.lpNorm<1>());
    }
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      if (!keeps_away(edges_[i], i, furthest)) return false;
    }
    return geom::contains(polygon_, points.front().head<2>());
  }

 private:
  struct Edge {
    Vec2 a;
    Vec2 b;
    Vec2 out;      // a normal
    double reach;  // m that the reference point must stay away along it
  };

  bool keeps_away(const Edge& edge, std::size_t own, const std::vector<double>& furthest) const {
    const auto across = [&](std::size_t k) {
      const Vec2& out = edges_[k].out;
      return furthest[k] <= std::min(out.dot(edge.a), out.dot(edge.b));
    };
    if (across(own)) return true;
    for (std::size_t k = 0; k < edges_.size(); ++k) {
      if (across(k)) return true;
    }
    return false;
  }

  static double area_of(const std::vector<Vec2>& ring) {
    double area = 0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      const Vec2 a = ring[i] - ring[0];
      const Vec2 b = ring[i + 1] - ring[0];
      area += a.x() * b.y() - a.y() * b.x();
    }
    return area;
  }

  geom::Polygon polygon_;
  std::vector<Edge> edges_;
  double bottom_ = 0;
  double top_ = 0;
};

// Points in metres of the map.
bool holds_curve(const Inside& inside, const Points<kPoints>& q, double off, int depth) {
  if (inside.holds(q, off)) return true;
  if (depth == kDeepest || !inside.holds(std::span(q).first(1), off) ||
      !inside.holds(std::span(q).last(1), off)) {
    return false;
  }
  const auto [left, right] = halves(q);
  return holds_curve(inside, left, off, depth + 1) && holds_curve(inside, right, off, depth + 1);
}

std::optional<std::string> why_no_cover(const FlightOnEarth& flight, Ticks end,
                                        std::span<const geom::Volume4d> volumes) {
  for (const geom::Volume4d& v : volumes) {
    if (!v.lower || !v.upper || !v.start || !v.end) {
      return "a volume has no lower or upper altitude, no begin or no end";
    }
  }
  if (volumes.empty()) return "there is no volume";
  if (!geom::is_not_after(*volumes.front().start, flight.epoch, flight.flight.start)) {
    return fmt::format("the first volume begins after the departure, at {}",
                       *volumes.front().start);
  }
  for (std::size_t i = 1; i < volumes.size(); ++i) {
    if (geom::seconds_between(*volumes[i - 1].end, *volumes[i].start).most > 0) {
      return fmt::format("no volume holds from {} to {}", *volumes[i - 1].end, *volumes[i].start);
    }
  }
  if (!geom::is_not_before(*volumes.back().end, flight.epoch, seconds_not_below(end))) {
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
      Points<kPoints> q = stretch.curve.q;
      for (Vec3& p : q) p += window.from;
      if (holds_curve(inside, q, off, 0)) continue;
      return fmt::format("volume {} does not hold the vehicle at all times from {} to {}", i,
                         *volumes[i].start, *volumes[i].end);
    }
  }
  return std::nullopt;
}

}  // namespace traj
