#pragma once

// Where a path that is shorter than a given length may go.

#include "geom/base/vec3.h"

namespace plan {

// The points whose distances from both ends add up to at most `length`: a prolate spheroid with the
// ends as foci (Gammell et al. 2014, section III). `length` is at least the distance of the ends,
// or is taken as that.
class Spheroid {
 public:
  Spheroid(const geom::Vec3& from, const geom::Vec3& to, double length);

  double volume() const;  // cubic metres
  bool contains(const geom::Vec3& p) const;

  // Maps the unit ball onto the spheroid (to rounding), evenly (algorithm 2 of the paper).
  geom::Vec3 image(const geom::Vec3& unit) const;

 private:
  geom::Vec3 from_;
  geom::Vec3 to_;
  double length_;
  geom::Vec3 axis_[3];  // with the length of the half axis; the first is the long one
};

}  // namespace plan
