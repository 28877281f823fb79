#include <algorithm>
#include <optional>

#include "gmp_line.h"
#include "together/judgeable.h"
#include "traj/together/exact/exact_pair.h"

namespace traj {
namespace {

using exact::Curve;
using exact::Line;
using exact::Point;
using exact::Scaled;
using exact::Whole;
using exact::whole;

constexpr unsigned kDeepest = 60;
constexpr std::size_t kMostPieces = 1u << 18;  // of a pair
constexpr double kSideLength = 1 << 20;        // of an upright side: as fine as it needs to be

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
  require_judgeable(a);
  require_judgeable(b);
  for (const Zone& zone : zones) require_judgeable(zone);
  return PairProof(a, b).of(zones, parked);
}

}  // namespace traj
