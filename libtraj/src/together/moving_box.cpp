#include "traj/together/moving_box.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "curve/curve_piece.h"
#include "geom/base/error.h"
#include "geom/base/rounding.h"
#include "geom/record/flight_time.h"
#include "judgeable.h"
#include "place_at.h"
#include "timeline.h"

namespace traj {
namespace {

constexpr int kDeepest = 60;
constexpr double kSmallest = 1e-10;            // metres: a piece this small is not halved
constexpr std::size_t kMostPieces = 1u << 18;  // of a flight and a box

enum class Rounded { down, up };

double sum(double a, double b, Rounded to) {
  return to == Rounded::up ? geom::add_up(a, b) : geom::add_down(a, b);
}
double product(double a, double b, Rounded to) {
  return to == Rounded::up ? geom::multiply_up(a, b) : geom::multiply_down(a, b);
}

// How long it is there, rounded up: it then is there for longer.
double duration_of(const MovingBox& box) { return geom::add_up(box.until, -box.from); }

// A corner as a flight that goes straight, beyond where it really is by its rounding.
Trajectory corner_of(const MovingBox& box, Rounded to) {
  const bool up = to == Rounded::up;
  const Vec3& from = up ? box.box.max : box.box.min;
  Segment way;
  way.duration = duration_of(box);
  for (int axis = 0; axis < 3; ++axis) {
    const double speed = sum(box.velocity[axis], up ? box.growth[axis] : -box.growth[axis], to);
    for (std::size_t i = 0; i < kPoints; ++i) {
      const double seventh = product(speed, static_cast<double>(i), to);
      // A product's rounding is relative: a unit in the last place more holds a quotient's.
      const double step = product(seventh, way.duration, to) / kDegree;
      const double moved = up ? geom::next_up(step) : geom::next_down(step);
      way.point[i][axis] = i == 0 ? from[axis] : sum(from[axis], moved, to);
    }
  }
  return {{way}};
}

Trajectory standing(const Vec3& at, double duration) {
  Segment segment;
  segment.duration = duration;
  segment.point.fill(at);
  return {{segment}};
}

// What a flight is to the two corners on a stretch: the flight less the corner.
struct Sight {
  RelativeCurve low;
  RelativeCurve high;
  double begin;
  double end;
  double gap;
};

class MovingSearch {
 public:
  MovingSearch(const MovingBox& box, const Vec3& room)
      : room_(room),
        low_way_(corner_of(box, Rounded::down)),
        high_way_(corner_of(box, Rounded::up)),
        low_({&low_way_, box.from, Vec3::Zero()}),
        high_({&high_way_, box.from, Vec3::Zero()}) {}

  // False where it touches, or may touch; says where.
  bool clear_of(const Timeline& flight, MovingResult& result) {
    for (const CommonStretch& stretch : stretches(flight, low_, Parked::gone)) {
      const Sight sight{relative_curve(flight, low_, stretch),
                        relative_curve(flight, high_, stretch), seconds_of(*stretch.begin),
                        seconds_of(*stretch.end), flight.gap};
      const Piece low{sight.low.q, sight.begin, sight.end};
      const Piece high{sight.high.q, sight.begin, sight.end};
      if (!apart(sight, low, high, 0, result)) return false;
    }
    return true;
  }

 private:
  static double off(const RelativeCurve& curve, double gap, int depth) {
    return geom::add_up(rounding_after(curve, depth), gap) * (1 + 0x1p-50);
  }

  // All of a piece on one side of a face.
  bool beyond(const Sight& sight, const Piece& low, const Piece& high, int depth) const {
    for (int axis = 0; axis < 3; ++axis) {
      const double above = geom::add_up(room_[axis], off(sight.high, sight.gap, depth));
      const double below = geom::add_up(room_[axis], off(sight.low, sight.gap, depth));
      const auto over = [&](const Vec3& p) { return p[axis] > above; };
      const auto under = [&](const Vec3& p) { return p[axis] < -below; };
      if (std::all_of(high.q.begin(), high.q.end(), over)) return true;
      if (std::all_of(low.q.begin(), low.q.end(), under)) return true;
    }
    return false;
  }

  // Surely in contact: between the faces by more than rounding, or at least no less.
  bool within(const Sight& sight, const Vec3& low, const Vec3& high, int depth) const {
    for (int axis = 0; axis < 3; ++axis) {
      const bool inside = high[axis] + off(sight.high, sight.gap, depth) <= room_[axis] &&
                          low[axis] - off(sight.low, sight.gap, depth) >= -room_[axis];
      if (!inside) return false;
    }
    return true;
  }

  bool apart(const Sight& sight, const Piece& low, const Piece& high, int depth,
             MovingResult& result) {
    ++result.pieces;
    if (beyond(sight, low, high, depth)) return true;
    const bool at_begin = within(sight, low.q.front(), high.q.front(), depth);
    if (at_begin || within(sight, low.q.back(), high.q.back(), depth)) {
      result.time = at_begin ? low.begin : low.end;
      return false;
    }
    const geom::Aabb of_low = hull_box(low.q);
    const geom::Aabb of_high = hull_box(high.q);
    const Vec3 size = (of_low.max - of_low.min).cwiseMax(of_high.max - of_high.min);
    const double least = std::max(kSmallest, off(sight.low, sight.gap, depth));
    if (depth >= kDeepest || result.pieces >= kMostPieces || size.maxCoeff() < least) {
      result.time = low.begin;
      result.undecided = true;
      return false;
    }
    const auto [low_left, low_right] = low.halved();
    const auto [high_left, high_right] = high.halved();
    return apart(sight, low_left, high_left, depth + 1, result) &&
           apart(sight, low_right, high_right, depth + 1, result);
  }

  Vec3 room_;
  Trajectory low_way_;
  Trajectory high_way_;
  Timeline low_;
  Timeline high_;
};

}  // namespace

std::optional<geom::Fault> moving_box_fault(const MovingBox& box) {
  const auto within = [](const Vec3& v, double most) {
    return (v.cwiseAbs().array() <= most).all();
  };
  if (!within(box.box.min, geom::kLargestCoordinate) ||
      !within(box.box.max, geom::kLargestCoordinate)) {
    return geom::Fault{.key = "min and max",
                       .expected = fmt::format("metres within {:g}", geom::kLargestCoordinate)};
  }
  if (!(box.box.min.array() <= box.box.max.array()).all())
    return geom::Fault{.key = "min", .expected = "<= max on each axis"};
  if (!within(box.velocity, kFastestBox)) {
    return geom::Fault{.key = "velocity",
                       .expected = fmt::format("m/s within {:g} along each axis", kFastestBox)};
  }
  if (!within(box.growth, kFastestBox) || !(box.growth.array() >= 0).all()) {
    return geom::Fault{.key = "growth",
                       .expected = fmt::format("m/s from 0 to {:g} along each axis", kFastestBox)};
  }
  geom::FlightTime time;
  for (const double t : {box.from, box.until}) {
    time.start = t;
    if (geom::time_fault(time)) {
      return geom::Fault{.key = "from and until",
                         .expected = fmt::format(
                             "seconds after the epoch, 0 or from {:g} to {:g} on either side of it",
                             geom::kLeastTime, geom::kLargestTime),
                         .found = fmt::to_string(t)};
    }
  }
  if (!(box.from < box.until && duration_of(box) >= geom::kLeastTime)) {
    return geom::Fault{.key = "from",
                       .expected = "before until",
                       .found = fmt::format("{} and {}", box.from, box.until)};
  }
  for (const Rounded to : {Rounded::down, Rounded::up}) {
    if (within(corner_of(box, to).segments[0].point.back(), geom::kLargestCoordinate)) continue;
    return geom::Fault{.says = fmt::format("it must stay within {:g} m of zero until {} s",
                                           geom::kLargestCoordinate, box.until)};
  }
  return std::nullopt;
}

MovingResult check_moving(const TimedFlight& flight, const MovingBox& box, Parked parked) {
  if (auto fault = moving_box_fault(box)) throw geom::InputError("obstacle", *std::move(fault));
  require_judgeable(flight);
  MovingResult result;
  MovingSearch search(box, flight.room);
  const Timeline line(flight);
  result.clear = search.clear_of(line, result);
  const auto stands_clear = [&](const Vec3& at, double begin, double end) {
    const Trajectory pad = standing(at, std::max(geom::add_up(end, -begin), geom::kLeastTime));
    return search.clear_of(Timeline({&pad, begin, Vec3::Zero()}), result);
  };
  if (result.clear && parked == Parked::pad) {
    const auto& segments = flight.trajectory->segments;
    const double over = whole_time_below(seconds_below(line.joint.back()));
    if (box.from < flight.start) {
      result.clear =
          stands_clear(segments.front().point.front(), box.from, std::min(flight.start, box.until));
    }
    if (result.clear && box.until > over) {
      result.clear =
          stands_clear(segments.back().point.back(), std::max(box.from, over), box.until);
    }
  }
  if (!result.clear) result.place = place_at(flight, result.time);
  return result;
}

}  // namespace traj
