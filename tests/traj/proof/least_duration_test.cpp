#include "proof/least_duration.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "solve/time_scaling.h"
#include "support/random_city.h"
#include "traj/curve/trajectory.h"
#include "traj/proof/check.h"
#include "traj/scenes.h"

namespace traj {
namespace {

// Straight ahead, as fast as can be: speeds up at b, cruises at v, brakes at c.
long double bang_bang(long double d, long double v, long double b, long double c) {
  const long double ramps = v / b + v / c;  // from rest to v to rest
  if (d >= v * ramps / 2) return ramps + (d - v * ramps / 2) / v;
  const long double peak = std::sqrt(2 * d / (1 / b + 1 / c));
  return peak / b + peak / c;
}

Stretch line(const Vec3& from, const Vec3& to) { return {from, to, 0}; }
Stretch loop(double length) { return {Vec3::Zero(), Vec3::Zero(), length}; }

TEST(LeastDuration, OfAPathIsThatOfATrapezoid) {
  const auto found = least_duration(loop(100), {{Limit::speed, 8}, {Limit::acceleration, 6}});
  ASSERT_TRUE(found);
  EXPECT_LE(*found, 100.0 / 8 + 8.0 / 6);
  EXPECT_NEAR(*found, 100.0 / 8 + 8.0 / 6, 1e-12);
  EXPECT_NEAR(*least_duration(loop(1), {{Limit::speed, 8}, {Limit::acceleration, 6}}),
              2 * std::sqrt(1.0 / 6), 1e-12);  // it never reaches 8 m/s
}

TEST(LeastDuration, StandsOnEitherLimitAlone) {
  EXPECT_NEAR(*least_duration(loop(100), {{Limit::speed, 8}}), 12.5, 1e-12);
  EXPECT_NEAR(*least_duration(loop(100), {{Limit::acceleration, 4}}), 10, 1e-12);
}

TEST(LeastDuration, IsThereWhereSomethingIsLimited) {
  const Stretch stretch{{0, 0, 0}, {30, 0, 40}, 60};
  EXPECT_FALSE(least_duration(stretch, {}));
  EXPECT_FALSE(least_duration(stretch, {{Limit::jerk, 5}, {Limit::body_rate, 1}}));
  EXPECT_FALSE(least_duration(loop(0), {{Limit::speed, 8}}));  // nothing to bridge
  EXPECT_FALSE(least_duration(stretch, {{Limit::speed, 1e-12}}));
  EXPECT_FALSE(least_duration(stretch, {{Limit::speed, 8}, {Limit::thrust, 9}}));
  EXPECT_FALSE(least_duration(stretch, {{Limit::speed, std::nan("")}}));
}

// Vertical and horizontal speed apart: both at once go along a path, each along its own part.
TEST(LeastDuration, TakesTheSlowerOfHeightAndPlan) {
  const Limits limits{{Limit::horizontal_speed, 8}, {Limit::vertical_speed, 2}};
  EXPECT_NEAR(*least_duration({{0, 0, 0}, {0, 0, 0}, 100}, limits), 100 / std::sqrt(68.0), 1e-12);
  EXPECT_NEAR(*least_duration(line({1, 2, 0}, {61, 82, 5}), limits), 100 / 8.0, 1e-12);
  EXPECT_NEAR(*least_duration(line({1, 2, 0}, {61, 82, -50}), limits), 50 / 2.0, 1e-12);
  EXPECT_NEAR(*least_duration({{0, 0, 0}, {3, 0, 1}, 100}, {{Limit::horizontal_speed, 8}}), 3 / 8.0,
              1e-12);  // straight up and down as fast as one likes
}

// The thrust is along a + g: it holds the vehicle up first, and free fall is all that brakes a
// climb where it may not tilt over.
TEST(LeastDuration, KnowsWhatThrustAndTiltLeave) {
  const double g = kGravity;
  const Stretch climb = line({0, 0, 0}, {0, 0, 30});
  const auto exact = [](double d, double b, double c) {
    return static_cast<double>(bang_bang(d, 1e9, b, c));
  };
  EXPECT_NEAR(*least_duration(climb, {{Limit::thrust, 20}, {Limit::tilt, 0.5}}),
              exact(30, 20 - g, g), 1e-9);
  EXPECT_NEAR(*least_duration(climb, {{Limit::thrust, 20}}), exact(30, 20 - g, 20 + g), 1e-9);
  EXPECT_NEAR(*least_duration(climb, {{Limit::tilt, 0.5}}), std::sqrt(2 * 30 / g), 1e-9);
  const Stretch across = line({0, 0, 0}, {30, 40, 0});
  const double sideways = 20 * std::sin(0.5);
  EXPECT_NEAR(*least_duration(across, {{Limit::thrust, 20}, {Limit::tilt, 0.5}}),
              exact(50, sideways, sideways), 1e-6);
  EXPECT_NEAR(*least_duration(across, {{Limit::thrust, 20}, {Limit::tilt, 1.5}}), exact(50, 20, 20),
              1e-6);
  const double any = std::sqrt(400 + g * g - 40 * g * std::cos(0.5));
  EXPECT_NEAR(*least_duration(loop(50), {{Limit::thrust, 20}, {Limit::tilt, 0.5}}),
              exact(50, any, any), 1e-6);
  EXPECT_NEAR(*least_duration(loop(50), {{Limit::thrust, 20}}), exact(50, 20 + g, 20 + g), 1e-9);
}

// On a line the motion that is best is known, and the bound is it: never above, and below by a few
// roundings alone.
TEST(LeastDurationProperty, IsBangBangMotionOnALine) {
  support::Random random(7);
  for (int i = 0; i < 100'000; ++i) {
    const auto scale = [&](double low, double high) {
      return std::exp(random.uniform(std::log(low), std::log(high)));
    };
    const double d = scale(1e-6, 1e5);
    const double v = scale(1e-2, 1e3);
    const double a = scale(1e-2, 1e3);
    const Limits limits{{Limit::speed, v}, {Limit::acceleration, a}};
    const long double best = bang_bang(d, v, a, a);
    for (const Stretch& stretch :
         {loop(d), line({0, 0, 0}, {0, d, 0}), line({0, 0, d}, {0, 0, 0})}) {
      const auto found = least_duration(stretch, limits);
      ASSERT_TRUE(found) << i;
      ASSERT_LE(static_cast<long double>(*found), best) << "case " << i << ": " << d << ' ' << v;
      ASSERT_GE(*found, best * (1 - 1e-14L)) << "case " << i << ": " << d << ' ' << v;
    }
    const double f = kGravity * (1 + scale(1e-3, 10));
    const Limits upright{{Limit::speed, v}, {Limit::thrust, f}, {Limit::tilt, 0.3}};
    const long double up = static_cast<long double>(f) - kGravity;
    const auto rise = least_duration(line({0, 0, 0}, {0, 0, d}), upright);
    ASSERT_LE(static_cast<long double>(*rise), bang_bang(d, v, up, kGravity)) << "case " << i;
    ASSERT_GE(*rise, bang_bang(d, v, up, kGravity) * (1 - 1e-11L)) << "case " << i;
  }
}

double chords(const Trajectory& trajectory) {
  double sum = 0;
  Vec3 before = trajectory.segments.front().point[0];
  for (const Segment& s : trajectory.segments) {
    for (int i = 1; i <= 50; ++i) {
      const Vec3 p = evaluate(s, s.duration * i / 50).position;
      sum += (p - before).norm();
      before = p;
    }
  }
  return sum;
}

// No curve within random limits is faster, flown as fast as they allow.
TEST(LeastDurationProperty, IsUndercutByNoCurve) {
  support::Random random(11);
  double nearest = 0;
  for (int i = 0; i < 4'000; ++i) {
    Limits limits;
    const auto maybe = [&](Limit limit, double low, double high) {
      if (random.below(2) == 0) limits[limit] = random.uniform(low, high);
    };
    maybe(Limit::speed, 0.5, 10);
    maybe(Limit::horizontal_speed, 0.5, 10);
    maybe(Limit::vertical_speed, 0.2, 5);
    maybe(Limit::acceleration, 0.5, 10);
    maybe(Limit::thrust, 10.5, 25);
    maybe(Limit::tilt, 0.1, 1.3);
    Trajectory t = testing::random_trajectory(static_cast<unsigned>(i), 1 + i % 4);
    if (i % 3 == 0) {  // one line, straight up or across
      const Vec3 along = i % 2 == 0 ? Vec3(0, 0, 1) : Vec3(0.6, 0.8, 0);
      t.segments = {hermite({Vec3::Zero()}, {random.uniform(0.1, 100) * along}, 5)};
    }
    t = slowed(t, smallest_factor(t, limits));
    const Stretch stretch{t.segments.front().point[0], t.segments.back().point[kDegree],
                          chords(t) * (1 - 1e-12)};
    const auto found = least_duration(stretch, limits);
    if (!found) continue;
    ASSERT_LE(*found, duration(t)) << "case " << i;
    nearest = std::max(nearest, *found / duration(t));
  }
  EXPECT_GT(nearest, 0.6);  // else the bound would say little
}

}  // namespace
}  // namespace traj
