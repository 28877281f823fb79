#include "gmp_judge.h"

#include <algorithm>
#include <array>
#include <span>

namespace traj::exact {
namespace {

struct Interval {
  Whole low;
  Whole high;
};

Interval range(const std::vector<Point>& points, int axis) {
  const auto [low, high] =
      std::minmax_element(points.begin(), points.end(),
                          [axis](const Point& a, const Point& b) { return a[axis] < b[axis]; });
  return {(*low)[axis], (*high)[axis]};
}

// A normal across an axis and the chord of a curve, and where the curve lies along it.
struct Direction {
  int axis;
  Whole j, k;  // components along the next two axes; the one along `axis` is 0
  Interval curve;

  Direction(const Curve& c, int along) : axis(along) {
    const int a = (axis + 1) % 3;
    const int b = (axis + 2) % 3;
    j = c.points.front()[b] - c.points.back()[b];
    k = c.points.back()[a] - c.points.front()[a];
    for (const Point& p : c.points) {
      const Whole at = j * p[a] + k * p[b];
      if (&p == &c.points.front() || at < curve.low) curve.low = at;
      if (&p == &c.points.front() || at > curve.high) curve.high = at;
    }
  }

  // Whether the box is strictly on one side: +1 beyond the curve, -1 before it, 0 neither.
  int side(const Box& box, unsigned shift) const {
    const int a = (axis + 1) % 3;
    const int b = (axis + 2) % 3;
    const Whole low = j * (j > 0 ? box.low : box.high)[a] + k * (k > 0 ? box.low : box.high)[b];
    if ((low << shift) > curve.high) return 1;
    const Whole high = j * (j > 0 ? box.high : box.low)[a] + k * (k > 0 ? box.high : box.low)[b];
    if ((high << shift) < curve.low) return -1;
    return 0;
  }
};

std::optional<PieceAndPlane> separating(std::span<const Direction> directions, const Box& box,
                                        unsigned shift, std::size_t number) {
  for (const Direction& d : directions) {
    if (const int side = d.side(box, shift)) {
      return PieceAndPlane{number, box.index, d.axis, side > 0};
    }
  }
  return std::nullopt;
}

}  // namespace

int side_in_time(const Box& box, const Stretch& when) {
  if (box.from && *box.from << when.shift > when.end) return 1;
  if (box.until && *box.until << when.shift < when.begin) return -1;
  return 0;
}

bool holds_point(const Box& box, const Point& p, unsigned shift) {
  for (int axis = 0; axis < 3; ++axis) {
    if (p[axis] < box.low[axis] << shift || p[axis] > box.high[axis] << shift) return false;
  }
  return true;
}

Exposed exposed(Curve curve, const std::vector<const Box*>& boxes, Stretch when) {
  Exposed out{std::move(curve), {}, std::move(when)};
  std::array<Interval, 3> r;
  for (int axis = 0; axis < 3; ++axis) r[axis] = range(out.curve.points, axis);
  const unsigned shift = out.curve.shift;
  for (const Box* box : boxes) {
    bool apart = false;
    for (int axis = 0; axis < 3 && !apart; ++axis) {
      apart = r[axis].high < box->low[axis] << shift || r[axis].low > box->high[axis] << shift;
    }
    if (!apart) out.near.push_back(box);
  }
  return out;
}

std::pair<Exposed, Exposed> halves(const Exposed& piece) {
  auto [left, right] = halves(piece.curve);
  const Stretch& when = piece.when;
  const Whole middle = when.begin + when.end;
  const unsigned shift = when.shift + 1;
  return {exposed(std::move(left), piece.near, {when.begin << 1, middle, shift}),
          exposed(std::move(right), piece.near, {middle, when.end << 1, shift})};
}

Verdict JudgeClear::operator()(const Exposed& piece, std::size_t number) {
  if (piece.near.empty()) return Verdict::holds;
  const Curve& curve = piece.curve;
  const auto& [begin, end, shift] = piece.when;
  for (const Box* box : piece.near) {
    culprit = box->index;
    if (side_in_time(*box, {begin, begin, shift}) == 0 &&
        holds_point(*box, curve.points.front(), curve.shift)) {
      return Verdict::fails_at_begin;
    }
    if (side_in_time(*box, {end, end, shift}) == 0 &&
        holds_point(*box, curve.points.back(), curve.shift)) {
      return Verdict::fails_at_end;
    }
  }
  const Direction directions[] = {{curve, 0}, {curve, 1}, {curve, 2}};
  const std::size_t before = planes_.size();
  for (const Box* box : piece.near) {
    if (const int side = side_in_time(*box, piece.when)) {
      planes_.push_back({number, box->index, kTimeAxis, side > 0});
      continue;
    }
    if (const auto plane = separating(directions, *box, curve.shift, number)) {
      planes_.push_back(*plane);
      continue;
    }
    culprit = box->index;
    planes_.resize(before);
    return Verdict::unknown;
  }
  return Verdict::holds;
}

Verdict JudgeInside::operator()(const Curve& curve, std::size_t) const {
  const auto in = [&](const Point& p) { return holds_point(bounds, p, curve.shift); };
  if (std::all_of(curve.points.begin(), curve.points.end(), in)) return Verdict::holds;
  if (!in(curve.points.front())) return Verdict::fails_at_begin;
  return in(curve.points.back()) ? Verdict::unknown : Verdict::fails_at_end;
}

}  // namespace traj::exact
