#include "timeline.h"

#include <algorithm>
#include <cassert>

namespace traj {
namespace {

using Curve = Points<kPoints>;

// De Casteljau at `at`: the first part, or the second.
//
// Each step makes (1 - at) a + at b. With `at` right to 3 * 2^-53 and each operation to 2^-53, a
// coordinate of it is off by at most 10 * 2^-53 of the largest; seven steps lie on each other.
Curve part(Curve q, double at, bool second) {
  Curve out;
  for (std::size_t m = 0; m < q.size(); ++m) {
    out[second ? q.size() - 1 - m : m] = second ? q[q.size() - 1 - m] : q[0];
    for (std::size_t i = 0; i + 1 + m < q.size(); ++i) q[i] = (1 - at) * q[i] + at * q[i + 1];
  }
  return out;
}

Curve filled(const Vec3& p) {
  Curve q;
  q.fill(p);
  return q;
}

// The part of a segment that lasts from `begin` to `end`, within it.
struct Span {
  Ticks begin;
  Ticks end;
};

// The part of a curve over `whole` that lies in `wanted`.
Curve cut(const Curve& points, const Span& whole, const Span& wanted) {
  const auto& [from, until] = whole;
  const auto& [begin, end] = wanted;
  Curve q = points;
  if (end < until) q = part(q, ratio(end - from, until - from), false);
  if (begin > from) q = part(q, ratio(begin - from, end - from), true);
  return q;
}

// Each coordinate is rounded by 2^-53 of itself, not of the map's.
Curve seen_from(const Vec3& origin, Curve q) {
  for (Vec3& p : q) p -= origin;
  return q;
}

// Where one of the two flights is in a stretch.
struct Place {
  std::optional<std::size_t> segment;
  bool over;
};
Place place_of_first(const CommonStretch& s) { return {s.segment, s.first_over}; }
Place place_of_other(const CommonStretch& s) { return {s.other, s.other_over}; }

Curve points_of(const Timeline& line, const CommonStretch& stretch, const Place& place,
                const Vec3& origin) {
  const auto& segments = *line.segments;
  const auto& [segment, over] = place;
  if (!segment) {
    return seen_from(origin,
                     filled(over ? segments.back().point.back() : segments.front().point.front()));
  }
  const Curve q = seen_from(origin, segments[*segment].point);
  return cut(q, {line.joint[*segment], line.joint[*segment + 1]}, {*stretch.begin, *stretch.end});
}

double largest(const Curve& q) {
  double size = 0;
  for (const Vec3& p : q) size = std::max(size, p.cwiseAbs().maxCoeff());
  return size;
}

// Control points that a cut lies in the hull of.
double scale_of(const Timeline& line, const Place& place, const Vec3& origin) {
  const auto& segments = *line.segments;
  const auto& [segment, over] = place;
  if (segment) return largest(seen_from(origin, segments[*segment].point));
  const Vec3& p = over ? segments.back().point.back() : segments.front().point.front();
  return (p - origin).cwiseAbs().maxCoeff();
}

// The segment at all times shortly after `from`, where there is one.
std::optional<std::size_t> segment_after(const Timeline& line, Ticks from) {
  if (from < line.joint.front() || from >= line.joint.back()) return std::nullopt;
  const auto next = std::upper_bound(line.joint.begin(), line.joint.end(), from);
  return static_cast<std::size_t>(next - line.joint.begin()) - 1;
}

CommonStretch stretch_between(const Timeline& a, const Timeline& b, Ticks begin, Ticks end) {
  return {begin,
          end,
          segment_after(a, begin),
          segment_after(b, begin),
          begin >= a.joint.back(),
          begin >= b.joint.back()};
}

std::vector<Ticks> joints_between(const Timeline& a, const Timeline& b, Ticks begin, Ticks end) {
  std::vector<Ticks> out{begin, end};
  for (const Timeline* line : {&a, &b}) {
    for (const Ticks t : line->joint) {
      if (t > begin && t < end) out.push_back(t);
    }
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

}  // namespace

Timeline::Timeline(const TimedFlight& flight) : segments(&flight.trajectory->segments) {
  assert(!segments->empty());
  joint.push_back(ticks_of(flight.start));
  for (const Segment& s : *segments) joint.push_back(joint.back() + ticks_of(s.duration));
  for (std::size_t i = 0; i + 1 < segments->size(); ++i) {
    const Vec3& from = (*segments)[i].point.back();
    const Vec3& to = (*segments)[i + 1].point.front();
    for (int axis = 0; axis < 3; ++axis) {
      if (from[axis] == to[axis]) continue;
      gap = std::max(gap, geom::next_up(std::abs(to[axis] - from[axis])));
    }
  }
}

std::vector<CommonStretch> stretches(const Timeline& a, const Timeline& b, Parked parked) {
  std::vector<CommonStretch> out;
  const bool pad = parked == Parked::pad;
  const Ticks begin =
      pad ? std::min(a.joint.front(), b.joint.front()) : std::max(a.joint.front(), b.joint.front());
  const Ticks end =
      pad ? std::max(a.joint.back(), b.joint.back()) : std::min(a.joint.back(), b.joint.back());
  if (begin > end) return out;
  if (begin == end) {
    const bool a_over = begin == a.joint.back();
    const bool b_over = begin == b.joint.back();
    out.push_back({.begin = begin, .end = end, .first_over = a_over, .other_over = b_over});
    return out;
  }
  if (pad) out.push_back({.end = begin});
  const std::vector<Ticks> joints = joints_between(a, b, begin, end);
  for (std::size_t i = 0; i + 1 < joints.size(); ++i) {
    out.push_back(stretch_between(a, b, joints[i], joints[i + 1]));
  }
  if (pad) out.push_back({.begin = end, .first_over = true, .other_over = true});
  return out;
}

RelativeCurve relative_curve(const Timeline& a, const Timeline& b, const CommonStretch& stretch) {
  const Vec3 origin =
      a.segments->at(stretch.segment.value_or(stretch.first_over ? a.segments->size() - 1 : 0))
          .point.front();
  const Curve p = points_of(a, stretch, place_of_first(stretch), origin);
  const Curve o = points_of(b, stretch, place_of_other(stretch), origin);
  RelativeCurve out;
  for (std::size_t i = 0; i < p.size(); ++i) out.q[i] = p[i] - o[i];
  out.scale = std::max(scale_of(a, place_of_first(stretch), origin),
                       scale_of(b, place_of_other(stretch), origin));
  return out;
}

}  // namespace traj
