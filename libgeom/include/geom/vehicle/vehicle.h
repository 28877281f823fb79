#pragma once

// The body that must not touch anything: a box that holds the vehicle in every attitude.
//
// Example:
//   const geom::Vec3 body(0.098, 0.0925, 0.041);  // half sizes of a Tello with its guards, metres
//   const geom::Vehicle tello{.name = "tello",
//                             .half = geom::attitude_half_sizes(body, 0.61)};  // up to 35 degrees
//   assert(tello.half.z() > body.z());  // tilted it is higher

#include <optional>
#include <string>
#include <string_view>

#include "geom/base/vec3.h"
#include "geom/vehicle/limits.h"

namespace geom {

// `half`: half sizes in metres around the reference point, containing the body at every yaw and
// at every tilt the profile allows. `limits`: what its profile lets it do. `limits[Limit::tilt]` is
// the tilt up to which the box holds the body; without one it holds every attitude.
struct Vehicle {
  std::string name;
  Vec3 half = Vec3::Zero();
  Limits limits = {};

  friend bool operator==(const Vehicle&, const Vehicle&) = default;
};

// The half sizes of the smallest such box for a body of half sizes `body` that tilts by at most
// `tilt_max` radians (0 to pi/2): with r = hypot(a, b), the maxima over 0 <= t <= tilt_max of
// r cos t + c sin t (horizontal) and r sin t + c cos t (vertical), rounded up.
Vec3 attitude_half_sizes(const Vec3& body, double tilt_max);

}  // namespace geom
