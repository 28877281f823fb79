#pragma once

// A flight and an obstacle that moves, whose one contact is known by construction, in exact
// numbers.

#include <algorithm>
#include <array>

#include "support/random_city.h"
#include "support/touch_case.h"
#include "traj/together/moving_box.h"

namespace support {

using geom::Vec3;

// Places, speeds and times lie on grids fine and small enough that each double below is exact.
struct MovingCase {
  traj::Trajectory trajectory;
  double start = 0;
  Vec3 room = Vec3::Zero();
  traj::MovingBox box;
  traj::Parked parked = traj::Parked::gone;

  traj::TimedFlight flight() const { return {&trajectory, start, room}; }
};

// When they come nearest: as the flight turns round in front of a face, at a joint of it, at the
// first and the last instant of the obstacle, at departure and arrival of a flight that is gone
// otherwise, and before and after a flight on its pad.
enum class Contact { passing, joint, begin, end, departure, arrival, before, after };
inline constexpr int kContacts = 8;

// A box, and the face of it that the flight comes to: the upper one across `axis`, or the lower.
struct FacedBox {
  traj::MovingBox box;
  Vec3 room = Vec3::Zero();
  int axis = 0;
  double side = 1;

  // Of the face that is grown by the room.
  double face(double t) const {
    const Vec3& corner = side > 0 ? box.box.max : box.box.min;
    const double speed = box.velocity[axis] + side * box.growth[axis];
    return corner[axis] + speed * (t - box.from) + side * room[axis];
  }
  Vec3 middle(double t) const {
    return (box.box.min + box.box.max) / 2 + box.velocity * (t - box.from);
  }
  // Between that face and the opposite one.
  double thickness(double t) const {
    return (box.box.max - box.box.min + 2 * box.growth * (t - box.from) + 2 * room)[axis];
  }
};

// Every fourth has no size at first.
inline FacedBox random_faced_box(Random& random) {
  const auto vector = [&](double low, double high) {
    return Vec3(random.stepped(low, high, 0.125), random.stepped(low, high, 0.125),
                random.stepped(low, high, 0.125));
  };
  FacedBox out;
  out.axis = random.below(3);
  out.side = random.below(2) ? 1 : -1;
  out.room = random.below(5) ? vector(0, 2) : Vec3(Vec3::Zero());
  const Vec3 half = random.below(4) ? vector(0.5, 8) : Vec3(Vec3::Zero());
  const Vec3 middle = vector(-60, 60);
  out.box.box = {middle - half, middle + half};
  out.box.velocity = vector(-8, 8);
  if (random.below(4)) out.box.growth = vector(0, 2);
  return out;
}

using Distances = std::array<double, traj::kPoints>;

// The flight from `begin` for 7 steps of `step` seconds: so far beyond the face, and along the
// other axes well inside of the box.
inline traj::Segment segment_at(Random& random, const FacedBox& to, double begin, double step,
                                const Distances& beyond) {
  const Vec3 half = (to.box.box.max - to.box.box.min) / 2;
  traj::Segment out;
  out.duration = traj::kDegree * step;
  for (std::size_t i = 0; i < beyond.size(); ++i) {
    const double t = begin + static_cast<double>(i) * step;
    out.point[i] = to.middle(t);
    for (int k = 0; k < 3; ++k) out.point[i][k] += half[k] * random.stepped(-0.5, 0.5, 0.125);
    out.point[i][to.axis] = to.face(t) + to.side * beyond[i];
  }
  return out;
}

// Straight away from the face, `depth` inside of which it begins.
inline Distances away(Random& random, double depth) {
  Distances out;
  double way = -depth;
  for (double& d : out) {
    d = way;
    way += random.stepped(0.125, 4, 0.125);
  }
  return out;
}

inline Distances reversed(Distances d) {
  std::reverse(d.begin(), d.end());
  return d;
}

// A parabola whose lowest point, -depth, is at a share of the time.
inline Distances turning(Random& random, double share, double depth) {
  const double scale = random.stepped(0.125, 1, 0.125);
  Distances out;
  for (int i = 0; i < traj::kPoints; ++i) {
    out[static_cast<std::size_t>(i)] =
        scale * (i * (i - 1) - 12 * share * i + 42 * share * share) - depth;
  }
  return out;
}

// Goes through the face at constant speed, outwards, at a point's number.
inline Distances leaving(Random& random, int at, double depth) {
  const double scale = random.stepped(0.125, 2, 0.125);
  Distances out;
  for (int i = 0; i < traj::kPoints; ++i) {
    out[static_cast<std::size_t>(i)] = scale * (i - at) - depth;
  }
  return out;
}

// On its pad while the box is there, whose face comes up to the flight until its last instant, or
// goes away from its first one on.
inline void stand(Random& random, FacedBox& to, bool comes, double depth, MovingCase& out) {
  traj::MovingBox& box = to.box;
  const double speed = box.growth[to.axis] + random.stepped(0, 4, 0.125);
  box.velocity[to.axis] = comes ? to.side * (speed - 2 * box.growth[to.axis]) : -to.side * speed;
  box.until = box.from + random.stepped(0.125, 20, 0.125);
  const double t = comes ? box.until : box.from;
  const double step = random.stepped(0.125, 2, 0.125);
  out.parked = traj::Parked::pad;
  traj::Segment way;
  way.duration = traj::kDegree * step;
  for (Vec3& p : way.point) {
    p = Vec3(random.stepped(-90, 90, 0.125), random.stepped(-90, 90, 0.125),
             random.stepped(-90, 90, 0.125));
  }
  Vec3 pad = to.middle(t);
  pad[to.axis] = to.face(t) - to.side * std::min(depth, to.thickness(t));
  way.point.front() = way.point.back() = pad;
  out.trajectory.segments = {way};
}

// A flight that comes to `depth` metres inside of the obstacle grown by its room, once and no
// deeper; < 0: beyond it. A multiple of 2^-31, or < 0. As much as the obstacle is thick, at most.
inline MovingCase contact(Random& random, Contact how, double depth) {
  MovingCase out;
  FacedBox to = random_faced_box(random);
  traj::MovingBox& box = to.box;
  box.from = random.stepped(-86400, 86400, 0.125);
  auto& segments = out.trajectory.segments;
  const double step = random.stepped(0.125, 2, 0.125);
  const double before = random.stepped(0.125, 9, 0.125);
  const double time = traj::kDegree * step;
  const auto deep = [&](double t) { return std::min(depth, to.thickness(t)); };
  const auto fly = [&](double begin, const Distances& beyond) {
    segments.push_back(segment_at(random, to, begin, step, beyond));
  };
  out.start = box.from + before;
  box.until = out.start + 2 * time + before;
  const int at = random.below(traj::kPoints);
  const double there = static_cast<double>(at) * step;
  switch (how) {
    case Contact::passing:
      fly(out.start, turning(random, at / 8.0, deep(out.start + time * (at / 8.0))));
      break;
    case Contact::joint:
      fly(out.start, reversed(away(random, deep(out.start + time))));
      fly(out.start + time, away(random, deep(out.start + time)));
      segments[1].point.front() = segments[0].point.back();
      break;
    case Contact::begin:
      out.start = box.from - there;
      fly(out.start, leaving(random, at, deep(box.from)));
      break;
    case Contact::end:
      box.until = out.start + there;
      fly(out.start, reversed(leaving(random, traj::kDegree - at, deep(box.until))));
      break;
    case Contact::departure:
      fly(out.start, away(random, deep(out.start)));
      break;
    case Contact::arrival:
      fly(out.start, reversed(away(random, deep(out.start + time))));
      break;
    case Contact::before:
      stand(random, to, random.below(2), depth, out);
      out.start = box.until + (random.below(2) ? 0 : before);
      break;
    case Contact::after:
      stand(random, to, random.below(2), depth, out);
      out.start = box.from - out.trajectory.segments[0].duration - (random.below(2) ? 0 : before);
      break;
  }
  out.room = to.room;
  out.box = box;
  return out;
}

}  // namespace support
