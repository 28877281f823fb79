#include "fleet/meeting_times.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "geom/base/rounding.h"

namespace traj {
namespace {

using Vec2 = Eigen::Vector2d;

// Directions around the circle, each turned from the one before by the angle of the Pythagorean
// triple 11, 60, 61 (10.4 degrees). The polygon of their tangents reaches at most 1/240 beyond the
// circle. Each bounds the disc whatever its length, so that their rounding does not matter.
constexpr std::size_t kDirections = 35;

std::array<Vec2, kDirections> directions() {
  std::array<Vec2, kDirections> out;
  Vec2 n(1, 0);
  for (Vec2& direction : out) {
    direction = n;
    n = Vec2(60 * n.x() - 11 * n.y(), 11 * n.x() + 60 * n.y()) / 61;
  }
  return out;
}

const std::array<Vec2, kDirections> kAround = directions();

// Shares (u, w) of the times of two pieces: a convex polygon in the unit square.
//
// A side is cut with `slack` to spare, which is far more than the rounding of what is compared
// there; so what is left of the polygon holds all of what it should to within the rounding of a
// corner, 1e-14 a cut, and that is far less than the slack of the next cut.
class Shares {
 public:
  bool empty() const { return count_ == 0; }

  // Keeps c + g . (u, w) <= 0.
  void cut(double c, const Vec2& g, double slack) {
    std::array<double, kMost> over;
    bool all = true;
    for (std::size_t i = 0; i < count_; ++i) {
      over[i] = c + g.dot(corner_[i]) - slack;
      all = all && over[i] <= 0;
    }
    if (all) return;
    std::array<Vec2, kMost> kept;
    std::size_t n = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      if (n + 2 > kMost)
        return;  // only where rounding makes many sides of one: the cut is left out
      const std::size_t next = i + 1 < count_ ? i + 1 : 0;
      if (over[i] <= 0) kept[n++] = corner_[i];
      if ((over[i] <= 0) == (over[next] <= 0)) continue;
      const double share = std::clamp(over[i] / (over[i] - over[next]), 0.0, 1.0);
      kept[n++] = corner_[i] + share * (corner_[next] - corner_[i]);
    }
    corner_ = kept;
    count_ = n;
  }

  template <class F>
  void each_corner(const F& f) const {
    for (std::size_t i = 0; i < count_; ++i) f(corner_[i].x(), corner_[i].y());
  }

 private:
  static constexpr std::size_t kMost = 4 + kDirections + 8;

  std::array<Vec2, kMost> corner_{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)};
  std::size_t count_ = 4;
};

// Instants of a piece at a share of its time. Where it stands there for ever, all of them.
DepartureSpan instants(const StraightPiece& piece, double share) {
  if (!std::isfinite(piece.begin) || !std::isfinite(piece.end)) return {piece.begin, piece.end};
  const double t = piece.begin + share * (piece.end - piece.begin);
  return {t, t};
}

// What the corners may be off, as a share of the piece's time; and of what is worked out of them.
double blur_of(const StraightPiece& piece) {
  if (!std::isfinite(piece.begin) || !std::isfinite(piece.end)) return 0;
  return 1e-12 * (piece.end - piece.begin) + 0x1p-50 * std::abs(piece.end);
}

// Whether the pieces lie on two sides of an upright strip as wide as the zone: what most pairs that
// are apart are known by, in one look.
bool apart_across(const StraightPiece& first, const StraightPiece& second, double reach) {
  const Vec2 a = first.from.head<2>();
  const Vec2 b = second.from.head<2>();
  const Vec2 n = a + 0.5 * first.way.head<2>() - b - 0.5 * second.way.head<2>();
  const double nearest = n.dot(a - b) + std::min(0.0, n.dot(first.way.head<2>())) -
                         std::max(0.0, n.dot(second.way.head<2>()));
  const double norm = n.norm();
  return norm > 1e-100 && nearest > reach * norm;
}

}  // namespace

std::optional<DepartureSpan> meeting_times(const StraightPiece& first, const StraightPiece& second,
                                           const Zone& zone, const Vec3& growth) {
  assert(!zone.round || growth.isZero(0));
  const Vec3 apart = first.from - second.from;
  const double up = zone.reach.z() + first.off.up + second.off.up;
  const double across = first.off.across + second.off.across;
  const double size = first.from.cwiseAbs().maxCoeff() + second.from.cwiseAbs().maxCoeff() +
                      first.way.cwiseAbs().maxCoeff() + second.way.cwiseAbs().maxCoeff() +
                      zone.reach.maxCoeff() + growth.maxCoeff();
  const double slack = 1e-11 * size + 1e-9;
  Shares shares;
  const auto keep = [&](const Vec3& n, double reach) {
    const double grown = n.cwiseAbs().dot(growth);
    shares.cut(n.dot(apart) - reach, Vec2(n.dot(first.way) - grown, -n.dot(second.way)), slack);
    return !shares.empty();
  };
  // A box lies in the circle of its corners.
  const double widest = zone.round ? zone.reach.x() : (zone.reach + growth).head<2>().norm();
  if (apart_across(first, second, widest + across + slack)) return std::nullopt;
  if (!keep(Vec3::UnitZ(), up) || !keep(-Vec3::UnitZ(), up)) return std::nullopt;
  if (zone.round) {
    for (const Vec2& n : kAround) {
      const double reach = (zone.reach.x() + across) * n.norm();
      if (!keep(Vec3(n.x(), n.y(), 0), reach)) return std::nullopt;
    }
  } else {
    for (int axis = 0; axis < 2; ++axis) {
      const double reach = zone.reach[axis] + across;
      if (!keep(Vec3::Unit(axis), reach) || !keep(-Vec3::Unit(axis), reach)) return std::nullopt;
    }
  }
  DepartureSpan span{std::numeric_limits<double>::infinity(),
                     -std::numeric_limits<double>::infinity()};
  shares.each_corner([&](double u, double w) {
    const DepartureSpan t = instants(first, u);
    const DepartureSpan s = instants(second, w);
    span.low = std::min(span.low, t.low - s.high);
    span.high = std::max(span.high, t.high - s.low);
  });
  const double blur = blur_of(first) + blur_of(second) + 1e-9;
  return DepartureSpan{span.low - blur, span.high + blur};
}

}  // namespace traj
