#include "traj/proof/domain.h"

#include <gtest/gtest.h>

#include <limits>

#include "geom/base/error.h"
#include "support/random_city.h"
#include "traj/proof/check.h"
#include "traj/proof/exact/exact_check.h"
#include "traj/scenes.h"

namespace traj {
namespace {

using geom::CollisionScene;
using testing::one_box;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

const CollisionScene& scene() {
  static const CollisionScene kScene(one_box(), {"box", {0.5, 0.5, 0.5}}, 0.1);
  return kScene;
}

ExactResult exactly(const Trajectory& t, const Limits& limits) {
  return check_exactly({scene().map(), scene().vehicle(), scene().margin(), limits}, t);
}

Segment standing(double duration) {
  Segment out;
  out.duration = duration;
  out.point.fill(Vec3(5, 5, 5));
  return out;
}

Trajectory crossing() {
  const State begin{{-20, 5, 3}, Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  const State middle{{0, 6, 4}, {4, 0, 0}, {0, 0, 1}, Vec3::Zero()};
  const State end{{20, 5, 3}, Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  return {{hermite(begin, middle, 6), hermite(middle, end, 6)}};
}

void expect_refused_by_both(const Trajectory& t, const Limits& limits, Reason reason,
                            const std::string& what) {
  const CheckResult fast = check(scene(), t, limits);
  const ExactResult exact = exactly(t, limits);
  EXPECT_FALSE(fast.ok) << what;
  EXPECT_FALSE(exact.ok) << what;
  EXPECT_EQ(fast.reason, reason) << what;
  EXPECT_EQ(exact.reason, reason) << what;
  EXPECT_EQ(fast.duration, 0) << what << ": what was not measured is not reported";
}

TEST(Domain, HoldsWhatCanBeFlown) {
  EXPECT_FALSE(
      outside_domain(crossing(), {{Limit::speed, 8}, {Limit::tilt, 0.6}, {Limit::thrust, 20}}));
  EXPECT_TRUE(check(scene(), crossing(), Limits{{Limit::speed, 8}}).ok);
  EXPECT_TRUE(exactly(crossing(), {{Limit::speed, 8}}).ok);
  EXPECT_TRUE(check(scene(), {{standing(kShortestSegment)}}, Limits{}).ok);
  EXPECT_TRUE(check(scene(), {{standing(kLongestTrajectory)}}, Limits{}).ok);
  EXPECT_TRUE(exactly({{standing(kLongestTrajectory)}}, {}).ok);
}

TEST(Domain, RefusesDurationsInBothChecks) {
  for (const double duration : {0.0, -0.0, -1.0, 5e-324, 1e-310, 1e-300, 1e-100, 1e-10, 1.1e9, 1e15,
                                1e154, 1e300, kInf, -kInf, kNaN}) {
    const std::string what = "duration " + std::to_string(duration);
    expect_refused_by_both({{standing(duration)}}, {}, Reason::duration, what);
    Trajectory t = crossing();
    t.segments[1].duration = duration;
    expect_refused_by_both(t, {{Limit::speed, 1e9}}, Reason::duration, what);
    t = crossing();
    t.segments.insert(t.segments.begin() + 1, {standing(duration)});
    expect_refused_by_both(t, {}, Reason::duration, what);
  }
  expect_refused_by_both({}, {}, Reason::duration, "no segment");
  expect_refused_by_both({{standing(6e8), standing(6e8)}}, {}, Reason::duration, "too long in all");
}

TEST(Domain, RefusesCoordinatesInBothChecks) {
  for (const double value : {1.1e8, -1e9, 1e154, -1e200, 1e300, 1.7e308, kInf, -kInf, kNaN}) {
    for (std::size_t i = 0; i < kPoints; ++i) {
      Trajectory t = crossing();
      t.segments[i % 2].point[i][static_cast<int>(i % 3)] = value;
      expect_refused_by_both(t, {}, Reason::coordinates, "coordinate " + std::to_string(value));
      t = crossing();
      t.segments[0].yaw.emplace().fill(0);
      (*t.segments[0].yaw)[i] = value;
      expect_refused_by_both(t, {}, Reason::coordinates, "yaw " + std::to_string(value));
    }
    const Vec3 way[] = {{5, 5, 5}, {6, value, 5}, {7, 5, 5}};
    EXPECT_EQ(check_path(scene(), way).reason, Reason::coordinates) << value;
    const ExactTask task{scene().map(), scene().vehicle(), scene().margin(), {}};
    EXPECT_EQ(check_exactly(task, way).reason, Reason::coordinates) << value;
  }
}

TEST(Domain, RefusesLimitsInBothChecks) {
  for (const LimitKind& kind : kLimitKinds) {
    for (const double value :
         {0.0, -0.0, -1.0, -1e9, 5e-324, 1e-320, 1e-310, 1e-10, 1e10, 1e300, kInf, -kInf, kNaN}) {
      Limits limits;
      limits[kind.limit] = value;
      expect_refused_by_both(crossing(), limits, Reason::limits,
                             std::string(kind.name) + ' ' + std::to_string(value));
    }
  }
  for (const double tilt : {1.5707963267948966, 1.6, 3.141592653589793, 4.0, 100.0}) {
    expect_refused_by_both(crossing(), {{Limit::tilt, tilt}}, Reason::limits,
                           "tilt " + std::to_string(tilt));
  }
  for (const double thrust : {1.0, 9.0, 9.80665}) {
    expect_refused_by_both(crossing(), {{Limit::thrust, thrust}}, Reason::limits,
                           std::to_string(thrust));
  }
}

TEST(Domain, RefusesVehiclesOfTheExactCheck) {
  for (const double size : {-1.0, -1e-9, 1e9, 1e154, 1e300, kInf, kNaN}) {
    const geom::BoxMap& map = scene().map();
    EXPECT_EQ(check_exactly({map, {"box", {0.5, size, 0.5}}, 0, {}}, crossing()).reason,
              Reason::vehicle);
    EXPECT_EQ(check_exactly({map, {"box", {0.5, 0.5, 0.5}}, size, {}}, crossing()).reason,
              Reason::vehicle);
    const Vec3 way[] = {{5, 5, 5}, {6, 5, 5}};
    EXPECT_EQ(check_exactly({map, {"box", {0.5, 0.5, 0.5}}, size, {}}, way).reason,
              Reason::vehicle);
  }
}

TEST(Domain, ToleranceThatIsNoNumberIsRefused) {
  for (double CheckOptions::*tolerance :
       {&CheckOptions::position_gap, &CheckOptions::velocity_gap, &CheckOptions::acceleration_gap,
        &CheckOptions::yaw_gap, &CheckOptions::yaw_rate_gap, &CheckOptions::limit_slack}) {
    CheckOptions odd;
    odd.*tolerance = kNaN;
    EXPECT_THROW(check(scene(), crossing(), odd), geom::InputError);
  }
}

// Numbers of any size anywhere: what the check accepts the exact check accepts, and neither
// anything outside the domain.
TEST(DomainProperty, ExtremesAreNeverAccepted) {
  support::Random random(1504);
  const double sizes[] = {0,    5e-324, 1e-310, 1e-300, 1e-155,  1e-30, 1e-9,   1e-3,
                          0.5,  1,      30,     1e4,    9e7,     1e8,   1.01e8, 1e9,
                          1e15, 1e77,   1e154,  1e300,  1.7e308, kInf,  kNaN};
  const auto any = [&] {
    const double size = sizes[random.below(static_cast<int>(std::size(sizes)))];
    return random.below(2) ? size : -size;
  };
  int accepted = 0;
  for (int i = 0; i < 20000; ++i) {
    Trajectory t = random.below(3) ? crossing() : Trajectory{{standing(1), standing(1)}};
    if (random.below(2)) {
      for (Segment& s : t.segments) s.yaw.emplace().fill(0.25);
    }
    Limits limits;
    for (int k = random.below(3); k >= 0; --k) {
      Segment& s = t.segments[static_cast<std::size_t>(random.below(2))];
      const auto at = static_cast<std::size_t>(random.below(kPoints));
      switch (random.below(4)) {
        case 0:
          s.duration = any();
          break;
        case 1:
          s.point[at][random.below(3)] = any();
          break;
        case 2:
          if (s.yaw) (*s.yaw)[at] = any();
          break;
        default:
          limits.values[random.below(static_cast<int>(geom::kLimits))] = any();
      }
    }
    const CheckResult fast = check(scene(), t, limits);
    const ExactResult exact = exactly(t, limits);
    ASSERT_FALSE(fast.ok && !exact.ok) << "case " << i << ": exact " << name(exact.reason);
    ASSERT_FALSE(outside_domain(t, limits) && (fast.ok || exact.ok)) << "case " << i;
    ASSERT_EQ(outside_domain(t, limits) ? outside_domain(t, limits)->reason : fast.reason,
              fast.reason);
    accepted += fast.ok;
  }
  EXPECT_GT(accepted, 500);
}

}  // namespace
}  // namespace traj
