#include "proof/least_duration.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "curve/portable_math.h"
#include "geom/base/rounding.h"
#include "traj/proof/domain.h"

namespace traj {
namespace {

using geom::add_down;
using geom::add_up;
using geom::multiply_down;
using geom::multiply_up;
using geom::next_down;
using geom::next_up;

using Most = std::optional<double>;  // of a speed or an acceleration; absent: any

constexpr double kSteepest = 1.4;   // rad: nearer to a right angle the tangent is not made use of
constexpr double kShortest = 1e-9;  // metres: less counts as 0, so that products are normal
constexpr double kLongest = 1e12;   // and more as this

// Quotients and roots are the nearest double, so that its neighbour is on the side asked for.
double divide_down(double a, double b) { return std::max(0.0, next_down(a / b)); }
double root_down(double a) { return std::max(0.0, next_down(std::sqrt(a))); }
double root_up(double a) { return next_up(std::sqrt(a)); }

Most smaller(const Most& a, const Most& b) {
  if (!a || !b) return a ? a : b;
  return std::min(*a, *b);
}

Most norm_up(const Most& a, const Most& b) {
  if (!a || !b) return std::nullopt;
  return root_up(add_up(multiply_up(*a, *a), multiply_up(*b, *b)));
}

double norm_down(double a, double b) {
  return root_down(add_down(multiply_down(a, a), multiply_down(b, b)));
}

double apart_down(double a, double b) { return std::max(add_down(a, -b), add_down(b, -a)); }
double counted(double metres) { return metres < kShortest ? 0 : std::min(metres, kLongest); }

// Motion along one line, or of a speed along a curve.
struct Motion {
  double distance = 0;  // at least
  Most speed;           // at most, as all below
  Most faster;          // of the acceleration one way
  Most slower;          // and the other
};

// 1 / a, at most the real one; 0 where there is no limit.
double inverse(const Most& most) { return most ? divide_down(1, *most) : 0; }

// From rest to rest: as fast as can be, cruising where the speed allows no more, and braking.
double least_time(const Motion& motion) {
  const double half = 0.5 * add_down(inverse(motion.faster), inverse(motion.slower));
  const double unlimited = root_down(multiply_down(multiply_down(4, motion.distance), half));
  if (!motion.speed) return unlimited;
  const double v = *motion.speed;
  // Cruising, where it is not reached, would be more than the least.
  if (!(motion.distance >= multiply_up(multiply_up(v, v), half))) return unlimited;
  return add_down(divide_down(motion.distance, v), multiply_down(v, half));
}

// What thrust and tilt leave of accelerations: the thrust is along a + g.
struct Accelerations {
  Most any, across, up, down;
};

// Of the angles from upright within a tilt: at most the least cosine, at least the largest sine.
struct Cone {
  double cosine = 0;
  double sine = 1;
};

Cone cone_of(const Most& tilt) {
  if (!tilt || *tilt > kSteepest) return {};
  const double tangent = tangent_below(*tilt) * (1 + 1e-9);
  return {divide_down(1, root_up(add_up(1, multiply_up(tangent, tangent)))),
          std::min(1.0, next_up(tangent / norm_down(1, tangent)))};
}

Accelerations accelerations(const Limits& limits) {
  const Most& most = limits[Limit::acceleration];
  Accelerations out{most, most, most, most};
  const Most& tilt = limits[Limit::tilt];
  if (tilt) out.down = smaller(most, kGravity);
  const Most& thrust = limits[Limit::thrust];
  if (!thrust) return out;
  const double f = *thrust;
  const Cone cone = cone_of(tilt);
  const double squares = add_up(multiply_up(f, f), multiply_up(kGravity, kGravity));
  const double product = multiply_down(2 * kGravity, f);
  const double along = tilt ? multiply_down(product, cone.cosine) : -multiply_up(2 * kGravity, f);
  out.any = smaller(most, std::max(kGravity, root_up(add_up(squares, -along))));
  out.across = smaller(most, multiply_up(f, cone.sine));
  out.up = smaller(most, add_up(f, -kGravity));
  if (!tilt) out.down = smaller(most, add_up(f, kGravity));
  return out;
}

}  // namespace

std::optional<double> least_duration(const Stretch& stretch, const Limits& limits) {
  assert(stretch.length >= 0);
  if (outside_domain(limits)) return std::nullopt;
  const Most& speed = limits[Limit::speed];
  const Most& across = limits[Limit::horizontal_speed];
  const Most& up = limits[Limit::vertical_speed];
  const Accelerations most = accelerations(limits);
  const double x = counted(apart_down(stretch.from.x(), stretch.to.x()));
  const double y = counted(apart_down(stretch.from.y(), stretch.to.y()));
  const double z = counted(apart_down(stretch.from.z(), stretch.to.z()));
  const Motion along{counted(stretch.length), smaller(speed, norm_up(across, up)), most.any,
                     most.any};
  const Motion over{norm_down(x, y), smaller(speed, across), most.across, most.across};
  const Motion rise{z, smaller(speed, up), most.up, most.down};
  const double time = std::max({least_time(along), least_time(over), least_time(rise)});
  return time > 0 ? std::optional(time) : std::nullopt;
}

}  // namespace traj
