#include <algorithm>
#include <optional>

#include "proof/exact/gmp_bernstein.h"
#include "traj/together/exact/exact_pair.h"

namespace traj {
namespace {

using exact::Curve;
using exact::Point;
using exact::Polynomial;
using exact::Whole;
using exact::whole;

constexpr unsigned kDeepest = 60;
constexpr std::size_t kMostPieces = 1u << 18;  // of a pair
constexpr double kSideLength = 1 << 20;        // of an upright side: as fine as it needs to be

// Times of a flight in units of 2^-1074 s, and its segments.
struct Line {
  explicit Line(const TimedFlight& flight) : segments(flight.trajectory->segments) {
    joint.push_back(whole(flight.start));
    for (const Segment& s : segments) joint.push_back(joint.back() + whole(s.duration));
    for (std::size_t i = 0; i + 1 < segments.size(); ++i) {
      const Point end = whole(segments[i].point.back());
      const Point begin = whole(segments[i + 1].point.front());
      for (std::size_t axis = 0; axis < 3; ++axis) {
        gap = std::max<Whole>(gap, abs(begin[axis] - end[axis]));
      }
    }
  }

  const std::vector<Segment>& segments;
  std::vector<Whole> joint;
  Whole gap = 0;  // of a coordinate, in units of 2^-1074 m
};

// Control points times 2^1074 and times `factor`, which is > 0.
struct Scaled {
  std::array<Polynomial, 3> axes;
  Whole factor = 1;
};

Scaled constant(const Vec3& p) {
  Scaled out;
  const Point at = whole(p);
  for (std::size_t axis = 0; axis < 3; ++axis) out.axes[axis].assign(kPoints, at[axis]);
  return out;
}

// De Casteljau at share / of: the first part or the second, times of^7.
Polynomial part(Polynomial q, const Whole& share, const Whole& of, bool second) {
  const std::size_t n = q.size() - 1;
  const Whole rest = of - share;
  std::vector<Whole> power(n + 1, Whole(1));
  for (std::size_t m = 1; m <= n; ++m) power[m] = power[m - 1] * of;
  Polynomial out(n + 1);
  for (std::size_t m = 0; m <= n; ++m) {
    out[second ? n - m : m] = (second ? q[n - m] : q[0]) * power[n - m];
    for (std::size_t i = 0; i + m < n; ++i) q[i] = rest * q[i] + share * q[i + 1];
  }
  return out;
}

void cut(Scaled& curve, Whole share, Whole of, bool second) {
  const Whole common = gcd(share, of);
  share /= common;
  of /= common;
  for (Polynomial& q : curve.axes) q = part(std::move(q), share, of, second);
  for (std::size_t i = 1; i < kPoints; ++i) curve.factor *= of;
}

// The flight from `begin` to `end`, between which it has no joint; where it is parked, at rest.
Scaled between(const Line& line, const Whole& begin, const Whole& end) {
  if (end <= line.joint.front()) return constant(line.segments.front().point.front());
  if (begin >= line.joint.back()) return constant(line.segments.back().point.back());
  const auto next = std::upper_bound(line.joint.begin(), line.joint.end(), begin);
  const auto i = static_cast<std::size_t>(next - line.joint.begin()) - 1;
  Scaled out;
  for (const Vec3& p : line.segments[i].point) {
    const Point at = whole(p);
    for (std::size_t axis = 0; axis < 3; ++axis) out.axes[axis].push_back(at[axis]);
  }
  const Whole& from = line.joint[i];
  const Whole& until = line.joint[i + 1];
  if (end < until) cut(out, end - from, until - from, false);
  if (begin > from) cut(out, begin - from, end - from, true);
  return out;
}

// The first less the other, and what 1 m is in it.
struct Relative {
  Curve curve;
  Whole factor;  // of 2^-1074 m, without the curve's shift
};

Relative relative(const Scaled& a, const Scaled& b) {
  Relative out{{std::vector<Point>(kPoints), 0}, a.factor * b.factor};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < kPoints; ++i) {
      out.curve.points[i][axis] = a.axes[axis][i] * b.factor - b.axes[axis][i] * a.factor;
    }
  }
  return out;
}

struct Part {
  Whole begin;
  Whole end;
};

std::vector<Part> parts_of(const Line& a, const Line& b, Parked parked) {
  const bool pad = parked == Parked::pad;
  const Whole& first =
      pad == (a.joint.front() < b.joint.front()) ? a.joint.front() : b.joint.front();
  const Whole& last = pad == (a.joint.back() > b.joint.back()) ? a.joint.back() : b.joint.back();
  if (first > last) return {};
  std::vector<Whole> joints{first, last};
  for (const Line* line : {&a, &b}) {
    for (const Whole& t : line->joint) {
      if (t > first && t < last) joints.push_back(t);
    }
  }
  std::sort(joints.begin(), joints.end());
  joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
  std::vector<Part> out;
  if (pad || joints.size() == 1) out.push_back({first, first});
  for (std::size_t i = 0; i + 1 < joints.size(); ++i) out.push_back({joints[i], joints[i + 1]});
  if (pad) out.push_back({last, last});
  return out;
}

// A zone in the units of a relative curve: grown by what joints miss each other by, and as it is.
struct Bounds {
  Point reach;
  Whole gap;
  bool round;
};

// How far along the side a point is.
Whole along(const Side& side, const Point& p) {
  return side[0] * p[0] + side[1] * p[1] + side[2] * p[2];
}

bool is_beyond(const Bounds& zone, const Side& side, const Point& p) {
  const Whole sum = abs(Whole(side[0])) + abs(Whole(side[1])) + abs(Whole(side[2]));
  const Whole way = along(side, p) - zone.gap * sum;
  if (!zone.round || side[2] != 0) {
    return way > abs(Whole(side[0])) * zone.reach[0] + abs(Whole(side[1])) * zone.reach[1] +
                     abs(Whole(side[2])) * zone.reach[2];
  }
  const Whole square = Whole(side[0]) * side[0] + Whole(side[1]) * side[1];
  return way > 0 && way * way > zone.reach[0] * zone.reach[0] * square;
}

bool is_within(const Bounds& zone, const Point& p) {
  if (abs(p[2]) > zone.reach[2]) return false;
  if (!zone.round) return abs(p[0]) <= zone.reach[0] && abs(p[1]) <= zone.reach[1];
  return p[0] * p[0] + p[1] * p[1] <= zone.reach[0] * zone.reach[0];
}

// The direction of what is nearest of the chord in plan, about as long as kSideLength. Only a
// guess: is_beyond() decides.
std::optional<Side> upright_side(const Curve& curve) {
  const auto number = [](const Whole& x, long scale) {
    long exponent = 0;
    const double mantissa = mpz_get_d_2exp(&exponent, x.get_mpz_t());
    return std::ldexp(mantissa, static_cast<int>(exponent - scale));
  };
  const Point& p = curve.points.front();
  const Point& q = curve.points.back();
  long scale = 0;
  for (const Whole* x : {&p[0], &p[1], &q[0], &q[1]}) {
    scale = std::max(scale, static_cast<long>(mpz_sizeinbase(x->get_mpz_t(), 2)));
  }
  const Eigen::Vector2d from(number(p[0], scale), number(p[1], scale));
  const Eigen::Vector2d way = Eigen::Vector2d(number(q[0], scale), number(q[1], scale)) - from;
  const double square = way.squaredNorm();
  const double share = square > 0 ? std::clamp(-from.dot(way) / square, 0.0, 1.0) : 0;
  const Eigen::Vector2d nearest = from + share * way;
  const double length = nearest.norm();
  if (!(length > 0)) return std::nullopt;
  const Eigen::Vector2d side = nearest * (kSideLength / length);
  return Side{static_cast<std::int32_t>(std::lround(side.x())),
              static_cast<std::int32_t>(std::lround(side.y())), 0};
}

std::optional<Side> side_of(const Bounds& zone, const Curve& curve) {
  const auto all = [&](const Side& side) {
    return std::all_of(curve.points.begin(), curve.points.end(),
                       [&](const Point& p) { return is_beyond(zone, side, p); });
  };
  for (const int axis : {2, 0, 1}) {
    Side side{0, 0, 0};
    const auto i = static_cast<std::size_t>(axis);
    side[i] = curve.points.front()[i] < 0 ? -1 : 1;
    if (all(side)) return side;
  }
  if (!zone.round) return std::nullopt;
  const auto side = upright_side(curve);
  return side && all(*side) ? side : std::nullopt;
}

class PairProof {
 public:
  PairProof(const TimedFlight& a, const TimedFlight& b) : a_(a), b_(b) {}

  ExactPair of(std::span<const Zone> zones, Parked parked) {
    for (const Part& part : parts_of(a_, b_, parked)) {
      const Relative seen =
          relative(between(a_, part.begin, part.end), between(b_, part.begin, part.end));
      auto& covers = result_.stretches.emplace_back(zones.size());
      for (std::size_t i = 0; i < zones.size(); ++i) {
        const Point reach = whole(zones[i].reach);
        const Bounds bounds{
            {reach[0] * seen.factor, reach[1] * seen.factor, reach[2] * seen.factor},
            (a_.gap + b_.gap) * seen.factor,
            zones[i].round};
        if (!fill(bounds, seen.curve, 0, covers[i])) return result_;
      }
    }
    result_.apart = true;
    return result_;
  }

 private:
  bool fill(const Bounds& zone, const Curve& curve, unsigned depth, ApartCover& cover) {
    ++result_.pieces;
    const Bounds here{
        {zone.reach[0] << curve.shift, zone.reach[1] << curve.shift, zone.reach[2] << curve.shift},
        zone.gap << curve.shift,
        zone.round};
    if (const auto side = side_of(here, curve)) {
      cover.pieces.push_back(static_cast<std::uint8_t>(depth));
      cover.sides.push_back(*side);
      return true;
    }
    if (is_within(here, curve.points.front()) || is_within(here, curve.points.back())) return false;
    if (depth == kDeepest || result_.pieces >= kMostPieces) {
      result_.undecided = true;
      return false;
    }
    const auto [left, right] = exact::halves(curve);
    return fill(zone, left, depth + 1, cover) && fill(zone, right, depth + 1, cover);
  }

  Line a_;
  Line b_;
  ExactPair result_;
};

}  // namespace

ExactPair check_pair_exactly(const TimedFlight& a, const TimedFlight& b,
                             std::span<const Zone> zones, Parked parked) {
  return PairProof(a, b).of(zones, parked);
}

}  // namespace traj
