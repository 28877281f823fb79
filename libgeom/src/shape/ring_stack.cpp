#include "shape/ring_stack.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geom/base/error.h"
#include "unit_vector.h"

namespace geom {
namespace {

constexpr std::size_t kMostSides = 4096;
constexpr std::size_t kMostOfBall = 64;  // parts of a half turn: about 300,000 boxes

// The fewest equal parts of a half turn so that a circle of this radius and the polygon around it
// with sides over two parts each are at most `error` apart: r (1 / cos(angle / 2) - 1) <= error,
// and 1 / cos(x) - 1 <= 0.64 x^2 up to x = 0.8.
std::size_t parts_of_half_turn(double radius, double error, std::size_t most) {
  constexpr double kPi = 3.141592653589793;
  const double half = std::min(0.75, std::sqrt(error / (0.64 * radius)));
  const double parts = radius > 0 ? std::ceil(kPi / (2 * half)) : 1;
  if (!(parts <= static_cast<double>(most))) {
    throw InputError(
        "slack", {.says = fmt::format("a round body of radius {:.6g} m needs more than {} sides",
                                      radius, 2 * most),
                  .advice = "give more slack"});
  }
  return std::max<std::size_t>(4, static_cast<std::size_t>(parts));
}

// Directions of the corners of a regular polygon around the unit circle, touching it between them.
struct Around {
  explicit Around(std::size_t parts) {
    const std::vector<UnitVector> half = round_half_turn(2 * parts);  // every half side
    const double out = (1 + 1e-15) / half[1].cosine;
    for (std::size_t i = 0; i < 2 * parts; ++i) {
      const UnitVector& d = i < parts ? half[2 * i] : half[2 * (i - parts)];
      const double sign = i < parts ? out : -out;
      corners.push_back({sign * d.cosine, sign * d.sine});
    }
  }
  std::vector<Eigen::Vector2d> corners;
};

void add_ring(RingStack& stack, const Around& around, const Eigen::Vector2d& radii, double z) {
  for (const auto& c : around.corners) {
    stack.corners.push_back({radii.x() * c.x(), radii.y() * c.y(), z});
  }
}

// Corners of the profile of a half ball of radius 1 from its top down to its equator (height, and
// distance from the axis): a polygon around a quarter of the circle, touching it at both ends.
std::vector<UnitVector> quarter_profile(std::size_t parts) {
  const std::vector<UnitVector> half = round_half_turn(4 * parts);  // of the half turn, in halves
  const double out = (1 + 1e-15) / half[1].cosine;
  std::vector<UnitVector> profile;
  for (std::size_t i = 0; i < parts; ++i) {
    const UnitVector& d = half[2 * i + 1];
    profile.push_back({d.cosine * out, d.sine * out});
  }
  return profile;
}

}  // namespace

RingStack box_stack(const Vec3& size) {
  const Vec3 h = 0.5 * size;
  RingStack out{4, {}};
  for (const double z : {-h.z(), h.z()}) {
    out.corners.insert(
        out.corners.end(),
        {{-h.x(), -h.y(), z}, {h.x(), -h.y(), z}, {h.x(), h.y(), z}, {-h.x(), h.y(), z}});
  }
  return out;
}

RingStack cylinder_stack(double radius, double length, double error) {
  const Around around(parts_of_half_turn(radius, error, kMostSides / 2));
  RingStack out{around.corners.size(), {}};
  for (const double z : {-0.5 * length, 0.5 * length}) add_ring(out, around, {radius, radius}, z);
  return out;
}

RingStack cone_stack(double radius, double length, double error) {
  const Around around(parts_of_half_turn(radius, error, kMostSides / 2));
  RingStack out{around.corners.size(), {}};
  add_ring(out, around, {radius, radius}, -0.5 * length);
  add_ring(out, around, {0, 0}, 0.5 * length);
  return out;
}

// Each horizontal section is round, and lies inside that of the profile turned about the axis;
// polygons around its circles finish it. Stretched, what is inside stays inside.
RingStack ellipsoid_stack(const Vec3& radii, double error) {
  const double largest = radii.maxCoeff();
  const std::size_t parts = parts_of_half_turn(largest, 0.5 * error, kMostOfBall);
  const Around around(parts);
  const auto profile = quarter_profile((parts + 1) / 2);
  RingStack out{around.corners.size(), {}};
  for (const UnitVector& p : profile)
    add_ring(out, around, radii.head<2>() * p.sine, radii.z() * p.cosine);
  for (auto p = profile.rbegin(); p != profile.rend(); ++p)
    add_ring(out, around, radii.head<2>() * p->sine, -radii.z() * p->cosine);
  return out;
}

RingStack capsule_stack(double radius, double length, double error) {
  RingStack out = ellipsoid_stack(Vec3::Constant(radius), error);
  const std::size_t half = out.corners.size() / 2;
  for (std::size_t i = 0; i < out.corners.size(); ++i)
    out.corners[i].z() += i < half ? 0.5 * length : -0.5 * length;
  return out;
}

}  // namespace geom
