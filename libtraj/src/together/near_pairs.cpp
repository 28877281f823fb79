#include "traj/together/near_pairs.h"

#include <algorithm>

#include "box_tree.h"
#include "geom/base/parallel.h"
#include "geom/base/rounding.h"
#include "judgeable.h"
#include "timeline.h"

namespace traj {
namespace {

constexpr int kMostHalvings = 12;  // of a segment

// The boxes of one flight.
class Boxes {
 public:
  Boxes(const TimedFlight& flight, std::uint32_t index, const Spacing& spacing)
      : line_(flight), index_(index), reach_(reach_of(spacing, flight.room)) {}

  std::vector<TimedBox> all(Parked parked, double step) {
    for (std::size_t i = 0; i < line_.segments->size(); ++i) add_segment(i, step);
    if (parked == Parked::pad) {
      const Vec3& first = line_.segments->front().point.front();
      const Vec3& last = line_.segments->back().point.back();
      add({first, first}, -kInfinity, seconds_above(line_.joint.front()));
      add({last, last}, seconds_below(line_.joint.back()), kInfinity);
    }
    return std::move(out_);
  }

 private:
  void add_segment(std::size_t i, double step) {
    const Segment& segment = (*line_.segments)[i];
    const Vec3 origin = segment.point.front();
    Points<kPoints> q = segment.point;
    double scale = 0;
    for (Vec3& p : q) {
      p -= origin;
      scale = std::max(scale, p.cwiseAbs().maxCoeff());
    }
    halve(q, origin, scale, {line_.joint[i], line_.joint[i + 1]}, step, {0, 0});
  }

  // A segment, and which of its 2^depth parts.
  struct Span {
    Ticks begin;
    Ticks end;
  };
  struct Part {
    int depth;
    int number;
  };

  // Begin and end of a part: 2^112 ticks times 2^kMostHalvings fit.
  static double begin_of(const Span& time, const Part& part) {
    return seconds_below(time.begin + ((time.end - time.begin) * part.number >> part.depth));
  }
  static double end_of(const Span& time, const Part& part) {
    const Ticks length = (time.end - time.begin) * (part.number + 1);
    return seconds_above(time.begin + (length >> part.depth) + 1);
  }

  // Points relative to `origin`, each off by at most 16 * 2^-53 of `scale` a halving (timeline.h).
  void halve(const Points<kPoints>& q, const Vec3& origin, double scale, const Span& time,
             double step, const Part& part) {
    const geom::Aabb hull = hull_box(q);
    const auto [depth, number] = part;
    if (depth == kMostHalvings || (hull.max - hull.min).maxCoeff() <= step) {
      const Vec3 off = Vec3::Constant((16 * depth + 2) * 0x1p-53 * scale + 1e-300);
      geom::Aabb box;
      for (int axis = 0; axis < 3; ++axis) {
        box.min[axis] = geom::add_down(geom::next_down(hull.min[axis] - off[axis]), origin[axis]);
        box.max[axis] = geom::add_up(geom::next_up(hull.max[axis] + off[axis]), origin[axis]);
      }
      return add(box, begin_of(time, part), end_of(time, part));
    }
    const auto [left, right] = halves(q);
    halve(left, origin, scale, time, step, {depth + 1, 2 * number});
    halve(right, origin, scale, time, step, {depth + 1, 2 * number + 1});
  }

  void add(const geom::Aabb& place, double begin, double end) {
    TimedBox box;
    box.flight = index_;
    for (int axis = 0; axis < 3; ++axis) {
      const double reach = geom::add_up(reach_[axis], line_.gap);
      const auto i = static_cast<std::size_t>(axis);
      box.low[i] = geom::add_down(place.min[axis], -reach);
      box.high[i] = geom::add_up(place.max[axis], reach);
    }
    box.low[3] = begin;
    box.high[3] = end;
    out_.push_back(box);
  }

  Timeline line_;
  std::uint32_t index_;
  Vec3 reach_;
  std::vector<TimedBox> out_;
};

}  // namespace

std::vector<FlightPair> near_pairs(std::span<const TimedFlight> flights, const Spacing& spacing,
                                   Parked parked, const geom::Execution& run, double step) {
  require_judgeable(spacing);
  for (const TimedFlight& flight : flights) require_judgeable(flight);
  std::vector<std::vector<TimedBox>> of(flights.size());
  geom::parallel_for(flights.size(), {run.threads, {}}, [&](std::size_t i) {
    of[i] = Boxes(flights[i], static_cast<std::uint32_t>(i), spacing).all(parked, step);
  });
  std::vector<TimedBox> boxes;
  for (auto& part : of) {
    boxes.insert(boxes.end(), part.begin(), part.end());
    part = {};
  }
  return meeting_flights(std::move(boxes), {run.threads, {}});
}

}  // namespace traj
