#pragma once

// Curves cut by halving: what the proof and the measurements around it work on.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include "curve/halves.h"
#include "geom/shape/aabb.h"
#include "traj/curve/trajectory.h"

namespace traj {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <std::size_t N>
using Points = std::array<Vec3, N>;

template <std::size_t N>
geom::Aabb hull_box(const Points<N>& q) {
  geom::Aabb box{q[0], q[0]};
  for (const Vec3& p : q) box = geom::merged(box, {p, p});
  return box;
}

// The middle of the curve and a ball around it that holds the whole curve.
template <std::size_t N>
double radius_around(const Points<N>& q, const Vec3& middle) {
  double r = 0;
  for (const Vec3& p : q) r = std::max(r, (p - middle).squaredNorm());
  return std::sqrt(r);
}

inline Vec3 middle_of(const Points<kPoints>& q) { return halves(q).second[0]; }

// A degree-7 piece of a segment, with its place in time.
struct Piece {
  Points<kPoints> q;
  double begin;
  double end;
  Vec3 stray = Vec3::Zero();  // how far what is flown may be from it, along each axis

  double middle() const { return 0.5 * (begin + end); }
  std::pair<Piece, Piece> halved() const {
    const auto [l, r] = halves(q);
    return {{l, begin, middle(), stray}, {r, middle(), end, stray}};
  }
};

// Only what a report says hangs on these, never a verdict.
struct Largest {
  double value = -kInfinity;
  double time = 0;
  Vec3 place = Vec3::Zero();
};

struct Estimate {
  double value;  // at the middle of a piece
  double bound;  // no less than anywhere on it
};

// The largest of a function over a curve, by branch and bound to `tolerance`. `estimate(piece,
// middle)` may return anything no larger than `best` once it knows that the piece stays below.
template <class P, class F>
void search_largest(const std::vector<P>& pieces, double tolerance, const F& estimate,
                    Largest& best) {
  struct Entry {
    double bound;
    P piece;
    bool operator<(const Entry& other) const { return bound < other.bound; }
  };
  std::priority_queue<Entry> open;
  const auto look = [&](const P& piece) {
    const Vec3 p = middle_of(piece.q);
    const Estimate e = estimate(piece, p);
    if (e.value > best.value) best = {e.value, piece.middle(), p};
    if (e.bound > best.value + tolerance) open.push({e.bound, piece});
  };
  for (const P& piece : pieces) look(piece);
  for (int i = 0; i < 20000 && !open.empty(); ++i) {
    const Entry top = open.top();
    open.pop();
    if (top.bound <= best.value + tolerance) break;
    const auto [l, r] = top.piece.halved();
    look(l);
    look(r);
  }
}

inline std::vector<Piece> pieces_of(const Trajectory& trajectory) {
  std::vector<Piece> pieces;
  double t = 0;
  for (const Segment& s : trajectory.segments) {
    pieces.push_back({s.point, t, t + s.duration});
    t += s.duration;
  }
  return pieces;
}

}  // namespace traj
