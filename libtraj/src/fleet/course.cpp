#include "fleet/course.h"

#include <algorithm>
#include <cmath>

#include "curve/curve_piece.h"
#include "geom/base/rounding.h"

namespace traj {
namespace {

constexpr int kMostHalvings = 16;  // of a segment

// A curve relative to the first point of its segment.
struct Part {
  Points<kPoints> q;
  int depth = 0;
  int number = 0;  // of the 2^depth parts of the segment
};

// How far the curve is from the straight line between its ends, passed at constant speed: no
// further than its control points are from those of the line (the Bernstein form is linear in
// them, and has linear precision: Farin, Curves and Surfaces for CAGD, 5th edition, 6.3).
Bend bend_of(const Points<kPoints>& q) {
  double across = 0;
  double up = 0;
  for (int i = 1; i < kDegree; ++i) {
    const Vec3 straight = q[0] + (static_cast<double>(i) / kDegree) * (q[kDegree] - q[0]);
    const Vec3 off = q[static_cast<std::size_t>(i)] - straight;
    across = std::max(across, off.head<2>().squaredNorm());
    up = std::max(up, std::abs(off.z()));
  }
  return {std::sqrt(across), up};
}

// Each coordinate is off by at most 16 * 2^-53 of `scale` a halving, and as much again for what is
// worked out of it.
double rounding_of(double scale, int depth) { return (16 * depth + 32) * 0x1p-53 * scale + 1e-300; }

// The most that segments miss each other by at a joint, along an axis.
double gap_of(const std::vector<Segment>& segments) {
  double gap = 0;
  for (std::size_t i = 0; i + 1 < segments.size(); ++i) {
    const Vec3 step = segments[i + 1].point.front() - segments[i].point.back();
    if (!step.isZero(0)) gap = std::max(gap, geom::next_up(step.cwiseAbs().maxCoeff()));
  }
  return gap;
}

class Builder {
 public:
  Builder(const Trajectory& trajectory, const Bend& bend)
      : segments_(trajectory.segments), bend_(bend), gap_(gap_of(segments_)) {}

  Course build(Parked parked) {
    if (parked == Parked::pad) add_standing(segments_.front().point.front(), -kInfinity, 0);
    double time = 0;
    for (const Segment& segment : segments_) {
      add_segment(segment, time);
      time += segment.duration;
    }
    if (parked == Parked::pad) add_standing(segments_.back().point.back(), time, kInfinity);
    // A sum of so many durations, each rounded once; and what the shares of a segment are off.
    course_.blur = (static_cast<double>(segments_.size()) + 16) * 0x1p-52 * time;
    build_tree(0, course_.pieces.size());
    return std::move(course_);
  }

 private:
  void add_standing(const Vec3& place, double begin, double end) {
    course_.pieces.push_back({place, Vec3::Zero(), {2 * gap_, gap_}, begin, end});
  }

  void add_segment(const Segment& segment, double time) {
    const Vec3 origin = segment.point.front();
    Part whole{segment.point};
    double scale = 0;
    for (Vec3& p : whole.q) {
      p -= origin;
      scale = std::max(scale, p.cwiseAbs().maxCoeff());
    }
    halve(whole, origin, std::max(scale, origin.cwiseAbs().maxCoeff()), time, segment.duration);
  }

  void halve(const Part& part, const Vec3& origin, double scale, double time, double duration) {
    const Bend bend = bend_of(part.q);
    const double noise = 1e-12 * scale;  // halving would not get below it
    const bool straight = bend.across <= bend_.across + noise && bend.up <= bend_.up + noise;
    if (!straight && part.depth < kMostHalvings) {
      const auto [left, right] = halves(part.q);
      halve({left, part.depth + 1, 2 * part.number}, origin, scale, time, duration);
      halve({right, part.depth + 1, 2 * part.number + 1}, origin, scale, time, duration);
      return;
    }
    const double off = rounding_of(scale, part.depth) + gap_;
    const double share = std::ldexp(1.0, -part.depth);
    course_.pieces.push_back({origin + part.q.front(),
                              part.q.back() - part.q.front(),
                              {bend.across + 2 * off, bend.up + off},
                              time + part.number * share * duration,
                              time + (part.number + 1) * share * duration});
  }

  static CourseBox box_of(const StraightPiece& piece) {
    CourseBox box;
    const Vec3 to = piece.from + piece.way;
    const Vec3 off(piece.off.across, piece.off.across, piece.off.up);
    for (int axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<std::size_t>(axis);
      const double sure = off[axis] * (1 + 0x1p-40) + 1e-12 * (std::abs(to[axis]) + 1);
      box.low[i] = geom::float_down(std::min(piece.from[axis], to[axis]) - sure);
      box.high[i] = geom::float_up(std::max(piece.from[axis], to[axis]) + sure);
    }
    box.begin = geom::float_down(piece.begin);
    box.end = geom::float_up(piece.end);
    return box;
  }

  static CourseBox merged(CourseBox a, const CourseBox& b) {
    for (std::size_t i = 0; i < 3; ++i) {
      a.low[i] = std::min(a.low[i], b.low[i]);
      a.high[i] = std::max(a.high[i], b.high[i]);
    }
    a.begin = std::min(a.begin, b.begin);
    a.end = std::max(a.end, b.end);
    return a;
  }

  std::uint32_t build_tree(std::size_t first, std::size_t end) {
    const auto at = static_cast<std::uint32_t>(course_.nodes.size());
    course_.nodes.emplace_back();
    if (end - first == 1) {
      course_.nodes[at] = {box_of(course_.pieces[first]), 0, 0, static_cast<std::uint32_t>(first)};
      return at;
    }
    const std::size_t middle = first + (end - first) / 2;
    const std::uint32_t left = build_tree(first, middle);
    const std::uint32_t right = build_tree(middle, end);
    course_.nodes[at] = {merged(course_.nodes[left].box, course_.nodes[right].box), left, right, 0};
    return at;
  }

  const std::vector<Segment>& segments_;
  Bend bend_;
  double gap_;
  Course course_;
};

}  // namespace

Course course_of(const Trajectory& trajectory, Parked parked, const Bend& bend) {
  return Builder(trajectory, bend).build(parked);
}

}  // namespace traj
