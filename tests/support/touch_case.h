#pragma once

// Curves and one box whose distance is known by construction, in exact numbers.

#include <vector>

#include "geom/collision/collision.h"
#include "support/random_city.h"
#include "support/small_map.h"
#include "traj/curve/trajectory.h"

namespace support {

// Everything lies on a grid fine and small enough that each double below is exact: control points
// on 2^-10 m, the touched point at a multiple of 1/8 of the segment on 2^-31 m.
struct TouchCase {
  geom::Vec3 half;
  double margin = 0;
  traj::Trajectory trajectory;
  geom::Aabb box;
  std::vector<geom::Aabb> others;  // clear of the curve, see add_others

  geom::BoxMap map() const {
    std::vector<geom::Aabb> boxes = others;
    boxes.push_back(box);
    return map_of({geom::Vec3::Constant(-512), geom::Vec3::Constant(512)}, boxes);
  }
  geom::Vehicle vehicle() const { return {"box", half}; }
  geom::CollisionScene scene() const { return {map(), vehicle(), margin}; }
};

inline geom::Vec3 point_at(traj::Segment s, int eighths) {
  for (int bit = 4, at = 0; bit; bit /= 2) {
    std::array<geom::Vec3, traj::kPoints> left;
    std::array<geom::Vec3, traj::kPoints> right;
    for (int m = 0; m < traj::kPoints; ++m) {
      left[m] = s.point[0];
      right[traj::kDegree - m] = s.point[traj::kDegree - m];
      for (int i = 0; i + m < traj::kDegree; ++i) s.point[i] = (s.point[i] + s.point[i + 1]) / 2;
    }
    const bool later = at + bit <= eighths;
    at += later ? bit : 0;
    s.point = later ? right : left;
  }
  return s.point[0];
}

inline TouchCase touch_base(Random& random) {
  TouchCase c;
  for (int i = 0; i < 3; ++i) c.half[i] = random.stepped(0, 2, 0.0625);
  c.margin = random.stepped(0, 1, 0.125);
  traj::Segment s;
  s.duration = random.stepped(0.5, 8, 0.5);
  const geom::Vec3 from(random.uniform(-60, 60), random.uniform(-60, 60), random.uniform(-60, 60));
  for (geom::Vec3& p : s.point) {
    for (int i = 0; i < 3; ++i) {
      p[i] = std::floor((from[i] + random.uniform(-20, 20)) * 1024) / 1024;
    }
  }
  c.trajectory.segments = {s};
  return c;
}

// The box that, grown, holds `p` within `depth` of 1, 2 or 3 of its faces: a face, edge or corner.
inline geom::Aabb box_touched(Random& random, const TouchCase& c, const geom::Vec3& p,
                              double depth) {
  geom::Aabb box;
  const int faces = 1 + random.below(7);  // a bit an axis, at least one
  for (int i = 0; i < 3; ++i) {
    const double grown = c.half[i] + c.margin;
    const double size = random.stepped(4, 16, 1);
    const double beyond = faces >> i & 1 ? depth : random.stepped(0.5, 1.5, 0.125);
    // The face that faces -axis or +axis is `beyond` past the point.
    box.min[i] = p[i] - beyond + grown;
    box.max[i] = box.min[i] + size;
    if (random.below(2)) {
      box.max[i] = p[i] + beyond - grown;
      box.min[i] = box.max[i] - size;
    }
  }
  return box;
}

// A point of the curve `depth` (>= 0, a multiple of 2^-31) inside the grown box.
inline TouchCase touching(Random& random, double depth) {
  TouchCase c = touch_base(random);
  const int eighths = random.below(9);
  c.box = box_touched(random, c, point_at(c.trajectory.segments[0], eighths), depth);
  return c;
}

// A curve whose height rises to its middle and falls again, under a box whose grown lower face is
// `gap` metres above its highest point (a multiple of 2^-40; <= 0: it touches).
inline TouchCase under(Random& random, double gap) {
  TouchCase c = touch_base(random);
  traj::Segment& s = c.trajectory.segments[0];
  double height = s.point[0].z();
  for (int i = 0; i < traj::kPoints / 2; ++i) {
    height += random.stepped(0.25, 4, 0.25);
    s.point[i].z() = s.point[traj::kDegree - i].z() = height;
  }
  const geom::Vec3 top = point_at(s, 4);
  c.box.min = {top.x() - 30, top.y() - 30, top.z() + gap + c.half.z() + c.margin};
  c.box.max = c.box.min + geom::Vec3(60, 60, 5);
  return c;
}

// A curve along a straight line that passes a box edge at its middle, `gap` metres off along both
// axes across the edge (a multiple of 2^-40; <= 0: it touches).
inline TouchCase past_edge(Random& random, double gap) {
  TouchCase c = touch_base(random);
  traj::Segment& s = c.trajectory.segments[0];
  const geom::Vec3 middle = s.point[0];
  const geom::Vec3 along(random.stepped(1, 4, 0.25), -random.stepped(1, 4, 0.25),
                         random.stepped(-2, 2, 0.25));
  for (int i = 0; i < traj::kPoints / 2; ++i) {
    const geom::Vec3 way = random.stepped(0.25, 4, 0.25) * along;
    s.point[i] = middle - way;
    s.point[traj::kDegree - i] = middle + way;
  }
  const geom::Vec3 grown = c.half.array() + c.margin;
  c.box.min = {middle.x() + gap + grown.x(), middle.y() + gap + grown.y(), middle.z() - 20};
  c.box.max = c.box.min + geom::Vec3(30, 30, 40);
  return c;
}

// Up to 19 more boxes around the curve whose grown forms miss the box of its control points by at
// least 2^-9 m.
inline void add_others(Random& random, TouchCase& c) {
  const geom::Aabb hull = *geom::bounds(c.trajectory.segments[0].point);
  const geom::Vec3 reach = c.half.array() + (c.margin + 0x1p-9);
  for (int i = random.below(20); i > 0; --i) {
    geom::Aabb box;
    for (int axis = 0; axis < 3; ++axis) {
      box.min[axis] = random.stepped(hull.min[axis] - 20, hull.max[axis] + 10, 0.125);
      box.max[axis] = box.min[axis] + random.stepped(0, 10, 0.125);
    }
    if (!geom::overlap({box.min - reach, box.max + reach}, hull)) c.others.push_back(box);
  }
}

}  // namespace support
