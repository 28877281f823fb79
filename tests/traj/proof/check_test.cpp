#include "traj/proof/check.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "geom/base/error.h"
#include "solve/stop_and_go.h"
#include "support/random_city.h"
#include "support/segment_distance.h"
#include "traj/proof/exact/exact_check.h"
#include "traj/scenes.h"

namespace traj {
namespace {

using geom::CollisionScene;
using testing::arc;
using testing::one_box;
using testing::rest;

// A cube of 2 m in the middle, and a vehicle of 1 m.
const CollisionScene& cube() {
  static const CollisionScene made(one_box(), {"box", {0.5, 0.5, 0.5}}, 0);
  return made;
}

Trajectory moved(Trajectory t, const Vec3& by) {
  for (Segment& s : t.segments) {
    for (Vec3& p : s.point) p += by;
  }
  return t;
}

TEST(Check, AcceptsAClearCurveAndMeasuresItsClearance) {
  const Trajectory line = {{hermite(rest({-10, 4, 0}), rest({10, 4, 0}), 8)}};
  const CheckResult result = check(cube(), line, Limits{});
  EXPECT_TRUE(result.ok) << name(result.reason);
  ASSERT_TRUE(result.clearance);
  EXPECT_NEAR(result.clearance->value, 2.5, 1.1e-3);
  EXPECT_NEAR(result.largest[Limit::speed]->value, 20.0 / 8 * 35 / 16, 1e-3);
}

TEST(Check, SaysNoYesToWhatIsNotANumber) {
  const Trajectory line = {{hermite(rest({-10, 4, 0}), rest({10, 4, 0}), 8)}};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const LimitKind& kind : kLimitKinds) {
    for (const double wrong : {nan, -nan, -1.0}) {
      Limits limits;
      limits[kind.limit] = wrong;
      EXPECT_EQ(check(cube(), line, limits).reason, Reason::limits) << kind.name;
    }
  }
  for (double CheckOptions::*member :
       {&CheckOptions::position_gap, &CheckOptions::velocity_gap, &CheckOptions::acceleration_gap,
        &CheckOptions::yaw_gap, &CheckOptions::yaw_rate_gap, &CheckOptions::limit_slack,
        &CheckOptions::step_share}) {
    CheckOptions options;
    options.*member = nan;
    EXPECT_THROW(check(cube(), line, options), geom::InputError);
  }
  for (const double wrong : {nan, -1.0}) {
    for (double Stray::*member :
         {&Stray::velocity, &Stray::acceleration, &Stray::jerk, &Stray::yaw_rate}) {
      Stray stray;
      stray.*member = wrong;
      CheckOptions options;
      options.stray = {&stray, 1};
      EXPECT_THROW(check(cube(), line, options), geom::InputError);
    }
  }
  const Stray strays[2] = {};
  CheckOptions too_many;
  too_many.stray = strays;
  EXPECT_THROW(check(cube(), line, too_many), geom::InputError);
  const double wrongs[] = {nan, INFINITY, -INFINITY, 1e10, 1e155, 1e300, -1.7e308};
  for (const double wrong : wrongs) {
    for (int i = 0; i < kPoints; ++i) {
      Trajectory t = line;
      t.segments.push_back(t.segments[0]);
      t.segments[1].point[static_cast<std::size_t>(i)].z() = wrong;
      EXPECT_FALSE(check(cube(), t, Limits{}).ok) << wrong;
    }
    const Vec3 path[] = {{-10, 4, 0}, {10, 4, wrong}};
    EXPECT_EQ(check_path(cube(), path).reason, Reason::coordinates) << wrong;
    EXPECT_EQ(check_path(cube(), std::span(path).last(1)).reason, Reason::coordinates) << wrong;
  }
  for (const double duration : {nan, 0.0, -1.0, std::numeric_limits<double>::infinity()}) {
    Trajectory t = line;
    t.segments[0].duration = duration;
    EXPECT_FALSE(check(cube(), t, Limits{}).ok) << duration;
  }
}

TEST(Check, NamesPlaceTimeAndBoxOfTheWorstCollision) {
  const CheckResult result =
      check(cube(), {{hermite(rest({-10, 0, 0}), rest({10, 0, 0}), 8)}}, Limits{});
  EXPECT_EQ(result.reason, Reason::collision);
  EXPECT_NEAR(result.worst, 1.5, 1e-3);
  EXPECT_NEAR(result.time, 4, 0.05);
  EXPECT_EQ(result.box, 0u);
}

// A file's digits let segments miss each other by a little.
TEST(Check, NamesTheWorstCollisionWhereSegmentsMissEachOtherInIt) {
  const Trajectory t{{hermite(rest({-10, 0, 0}), rest({-1, 0, 0}), 8),
                      hermite(rest({-0.9999, 0, 0}), rest({10, 0, 0}), 8)}};
  CheckOptions options;
  options.position_gap = 1e-3;
  const CheckResult result = check(cube(), t, options);
  EXPECT_EQ(result.reason, Reason::collision);
  EXPECT_NEAR(result.worst, 1.5, 1e-3);
  EXPECT_EQ(result.box, 0u);
}

TEST(Check, SeesAWallThatIsThinnerThanAGap) {
  const CollisionScene scene(one_box({{0, -5, -5}, {1e-5, 5, 5}}), {"point", {0, 0, 0}}, 0);
  const Trajectory t{{hermite(rest({-10, 0, 0}), rest({-1e-5, 0, 0}), 8),
                      hermite(rest({3e-5, 0, 0}), rest({10, 0, 0}), 8)}};
  CheckOptions options;
  options.position_gap = 1e-3;
  const CheckResult result = check(scene, t, options);
  EXPECT_EQ(result.reason, Reason::collision);
  EXPECT_NEAR(result.time, 8, 1e-9);
  EXPECT_EQ(result.box, 0u);
}

TEST(Check, SeesGapsJumpsBoundsAndDurations) {
  Trajectory t = arc({0, 20, 0}, {3, 0, 0});
  EXPECT_TRUE(check(cube(), t, Limits{}).ok);
  Trajectory gap = t;
  for (Vec3& p : gap.segments[1].point) p.x() += 1e-6;
  EXPECT_EQ(check(cube(), gap, Limits{}).reason, Reason::discontinuous);
  Trajectory jump = t;
  jump.segments[1].duration = 3;
  EXPECT_EQ(check(cube(), jump, Limits{}).reason, Reason::discontinuous);
  EXPECT_EQ(check(cube(), moved(t, {0, 28, 0}), Limits{}).reason, Reason::bounds);
  t.segments[0].duration = 0;
  EXPECT_EQ(check(cube(), t, Limits{}).reason, Reason::duration);
  EXPECT_EQ(check(cube(), Trajectory{}, Limits{}).reason, Reason::duration);
}

TEST(Check, SeesAStepOfVelocityAccelerationYawOrYawRateAlone) {
  const State through{{0, 20, 0}, {3, 0, 0}, {0, 0, 1}, Vec3::Zero()};
  const auto reason_of = [&](const State& after, double yaw = 1, double yaw_rate = 0) {
    Trajectory t{{hermite(rest({-12, 23, 2}), through, 4), hermite(after, rest({13, 18, 5}), 4)}};
    t.segments[0].yaw.emplace().fill(1);
    auto& angles = t.segments[1].yaw.emplace();
    for (int i = 0; i <= kDegree; ++i) {
      angles[static_cast<std::size_t>(i)] = yaw + yaw_rate * 4 * i / kDegree;
    }
    return check(cube(), t, Limits{}).reason;
  };
  EXPECT_EQ(reason_of(through), Reason::none);
  State faster = through;
  faster.velocity.x() += 1e-5;
  EXPECT_EQ(reason_of(faster), Reason::discontinuous);
  State harder = through;
  harder.acceleration.x() += 1e-3;
  EXPECT_EQ(reason_of(harder), Reason::discontinuous);
  EXPECT_EQ(reason_of(through, 1 + 1e-6), Reason::discontinuous);
  EXPECT_EQ(reason_of(through, 1, 1e-4), Reason::discontinuous);
}

TEST(Check, HoldsEachLimitApart) {
  const Trajectory t = arc({0, 20, 0}, {6, 0, 0});
  const CheckResult free = check(cube(), t, Limits{});
  const auto with = [&](Limits limits) { return check(cube(), t, limits).reason; };
  EXPECT_EQ(with({{Limit::speed, free.largest[Limit::speed]->value * 1.001}}), Reason::none);
  EXPECT_EQ(with({{Limit::speed, free.largest[Limit::speed]->value * 0.999}}),
            broken(Limit::speed));
  EXPECT_EQ(with({{Limit::acceleration, free.largest[Limit::acceleration]->value * 0.999}}),
            broken(Limit::acceleration));
  EXPECT_EQ(with({{Limit::jerk, free.largest[Limit::jerk]->value * 0.999}}), broken(Limit::jerk));
  EXPECT_EQ(with({{Limit::tilt, 0.05}}), broken(Limit::tilt));
  EXPECT_EQ(with({{Limit::tilt, 1.5}}), Reason::none);
  EXPECT_EQ(with({{Limit::horizontal_speed, 0.5}}), broken(Limit::horizontal_speed));
  EXPECT_EQ(with({{Limit::horizontal_speed, free.largest[Limit::speed]->value * 1.001}}),
            Reason::none);
  const Trajectory climb = arc({0, 20, 0}, {0, 0, 6});
  const CheckResult up = check(cube(), climb, {{Limit::vertical_speed, 100}, {Limit::thrust, 100}});
  EXPECT_GT(up.largest[Limit::vertical_speed]->value, 0.1);
  EXPECT_EQ(check(cube(), climb,
                  {{Limit::vertical_speed, up.largest[Limit::vertical_speed]->value * 0.999}})
                .reason,
            broken(Limit::vertical_speed));
  EXPECT_EQ(
      check(cube(), climb, {{Limit::thrust, up.largest[Limit::thrust]->value * 0.999}}).reason,
      broken(Limit::thrust));
  EXPECT_EQ(
      check(cube(), climb, {{Limit::thrust, up.largest[Limit::thrust]->value * 1.001}}).reason,
      Reason::none);
  EXPECT_EQ(with({{Limit::body_rate, free.largest[Limit::body_rate]->value * 0.999}}),
            broken(Limit::body_rate));
  EXPECT_EQ(with({{Limit::body_rate, free.largest[Limit::body_rate]->value * 1.001}}),
            Reason::none);
  Trajectory turning = t;
  turning.segments[0].yaw = {0, 0, 0, 0, 1, 1, 1, 1};
  turning.segments[1].yaw = {1, 1, 1, 1, 0, 0, 0, 0};
  EXPECT_NEAR(check(cube(), turning, {{Limit::yaw_rate, 0.55}}).largest[Limit::yaw_rate]->value,
              35.0 / 16 / 4, 1e-4);
  EXPECT_EQ(check(cube(), turning, {{Limit::yaw_rate, 0.55}}).reason, Reason::none);
  EXPECT_EQ(check(cube(), turning, {{Limit::yaw_rate, 0.54}}).reason, broken(Limit::yaw_rate));
  turning.segments[1].yaw->front() = 1.1;
  EXPECT_EQ(check(cube(), turning, Limits{}).reason, Reason::discontinuous);
}

// However short it is, the yaw may jump there.
TEST(Check, AsksForYawInAllSegmentsWhereItsRateIsLimited) {
  Trajectory t = arc({0, 20, 0}, {6, 0, 0});
  const Limits limits{{Limit::yaw_rate, 100}};
  EXPECT_EQ(check(cube(), t, limits).reason, Reason::none) << "no yaw at all";
  t.segments[0].yaw = {0, 0, 0, 0, 0, 0, 0, 0};
  EXPECT_EQ(check(cube(), t, Limits{}).reason, Reason::none);
  const CheckResult result = check(cube(), t, limits);
  EXPECT_EQ(result.reason, unmeasured(Limit::yaw_rate));
  EXPECT_EQ(result.time, 4);
  EXPECT_EQ(result.place, t.segments[1].point.front());
  t.segments[1].yaw = t.segments[0].yaw;
  EXPECT_EQ(check(cube(), t, limits).reason, Reason::none);
}

// Segments of constant acceleration, each 9e-5 m/s2 more than the one before: 0.09 m/s3.
TEST(Check, TakesNoStepsThatAddUpToMoreThanALimit) {
  constexpr double kTime = 1e-3;
  State from{{0, 4, 0}, Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  Trajectory t;
  for (int i = 0; i < 200; ++i) {
    from.acceleration.x() = 9e-5 * i;
    State to = from;
    to.position += from.velocity * kTime + from.acceleration * (kTime * kTime / 2);
    to.velocity += from.acceleration * kTime;
    t.segments.push_back(hermite(from, to, kTime));
    from = to;
  }
  EXPECT_EQ(check(cube(), t, {{Limit::jerk, 0.02}}).reason, Reason::discontinuous);
  EXPECT_EQ(check(cube(), t, {{Limit::body_rate, 0.002}}).reason, Reason::discontinuous);
  EXPECT_EQ(check(cube(), t, {{Limit::jerk, 100}, {Limit::body_rate, 10}}).reason, Reason::none);
  EXPECT_EQ(check(cube(), t, Limits{}).reason, Reason::none);
  const auto exactly = [&](const Limits& limits) {
    return check_exactly({cube().map(), cube().vehicle(), cube().margin(), limits}, t).reason;
  };
  EXPECT_EQ(exactly({{Limit::jerk, 0.02}}), Reason::discontinuous);
  EXPECT_EQ(exactly({{Limit::body_rate, 0.002}}), Reason::discontinuous);
  EXPECT_EQ(exactly({{Limit::jerk, 100}, {Limit::body_rate, 10}}), Reason::none);
}

// Each extreme against the largest of many instants, which it is never below.
TEST(Check, MeasuresTheLargestThrustTiltAndBodyRate) {
  for (unsigned seed = 0; seed < 30; ++seed) {
    const Trajectory t = testing::random_trajectory(seed);
    const CheckResult result = check(cube(), t, Limits{});
    double thrust = 0;
    double tilt = 0;
    double rate = 0;
    for (int i = 0; i <= 20000; ++i) {
      const State s = evaluate(t, duration(t) * i / 20000);
      const Vec3 f = s.acceleration + kGravity * Vec3::UnitZ();
      thrust = std::max(thrust, f.norm());
      tilt = std::max(tilt, std::atan2(f.head<2>().norm(), f.z()));
      rate = std::max(rate, f.cross(s.jerk).norm() / f.squaredNorm());
    }
    EXPECT_LE(thrust, result.largest[Limit::thrust]->value * (1 + 1e-4) + 1e-9) << seed;
    EXPECT_NEAR(result.largest[Limit::thrust]->value, thrust, 2e-3 * thrust) << seed;
    EXPECT_LE(tilt, result.largest[Limit::tilt]->value * (1 + 1e-4) + 1e-9) << seed;
    EXPECT_NEAR(result.largest[Limit::tilt]->value, tilt, 1e-2) << seed;
    EXPECT_LE(rate, result.largest[Limit::body_rate]->value * (1 + 1e-4) + 1e-8) << seed;
    EXPECT_NEAR(result.largest[Limit::body_rate]->value, rate, 0.05 * rate) << seed;
  }
}

// Without thrust it may turn at any rate, all the way: neither refused where nothing is asked, nor
// looked at for ever.
TEST(Check, FreeFallBreaksOnlyALimitOfBodyRate) {
  for (const double across : {0.0, 0.5, 1e-9}) {
    Segment fall{2, {}, std::nullopt};
    for (int k = 0; k < kPoints; ++k) {  // -g t^2 / 2
      fall.point[static_cast<std::size_t>(k)] = {10 + across * k, 0,
                                                 -2 * kGravity * k * (k - 1) / 42.0};
    }
    EXPECT_TRUE(check(cube(), {{fall}}, Limits{}).ok) << across;
    EXPECT_EQ(check(cube(), {{fall}}, {{Limit::body_rate, 5}}).reason, broken(Limit::body_rate))
        << across;
  }
}

TEST(Check, AStraightSegmentOneNanometreClearIsDecidedExactly) {
  const double face = cube().grown(0).max.y();
  const auto along = [&](double y) {
    return check(cube(),
                 stop_and_go(std::vector<Vec3>{{-10, y, 0}, {10, y, 0}},
                             {{Limit::speed, 5}, {Limit::acceleration, 5}}),
                 Limits{})
        .ok;
  };
  EXPECT_FALSE(along(face));
  EXPECT_TRUE(along(std::nextafter(face, 10)));
}

TEST(CheckPath, IsExactOnEveryLeg) {
  const std::vector<Vec3> around = {{-10, 0, 0}, {0, 5, 0}, {10, 0, 0}};
  EXPECT_TRUE(check_path(cube(), around).ok);
  const std::vector<Vec3> through = {{-10, 0, 0}, {10, 0, 0}};
  EXPECT_EQ(check_path(cube(), through).reason, Reason::collision);
  EXPECT_EQ(check_path(cube(), {}).reason, Reason::no_path);
}

// By a look at every box.
double least_by_far(const CollisionScene& scene, const Vec3& a, const Vec3& b) {
  double least = std::numeric_limits<double>::infinity();
  for (const geom::Aabb& box : scene.map().boxes()) {
    least = std::min(least, oracle::segment_distance(a, b, geom::grow(box, scene.vehicle().half)));
  }
  return least;
}

TEST(CheckPath, MeasuresTheClearanceToRounding) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    // Few boxes, many, and many that are nothing beside the vehicle.
    const int count = seed % 3 == 0 ? 12 : 150;
    const double half = seed % 3 == 2 ? 6 : 0.5;
    const CollisionScene scene(support::random_city(seed, count, 120), {"box", {half, half, 0.5}},
                               seed % 2 ? 0.75 : 0);
    support::Random random(seed);
    for (int i = 0; i < 12; ++i) {
      std::vector<Vec3> path;
      for (int k = 0; k < 4; ++k) {
        path.emplace_back(random.stepped(-90, 90, 1), random.stepped(-90, 90, 1),
                          random.uniform(60, 115));
      }
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t k = 1; k < path.size(); ++k) {
        least = std::min(least, least_by_far(scene, path[k - 1], path[k]));
      }
      const CheckResult result = check_path(scene, path);
      ASSERT_TRUE(result.clearance);
      EXPECT_NEAR(result.clearance->value, least, 1e-9) << "seed " << seed << " path " << i;
      const double at = std::min(result.clearance->time, 2.999999999);
      const auto leg = static_cast<std::size_t>(at);
      const Vec3 place = path[leg] + (at - static_cast<double>(leg)) * (path[leg + 1] - path[leg]);
      EXPECT_NEAR(scene.nearest(place, 1e3)->distance, least, 1e-6);
    }
  }
}

TEST(Check, MeasuresTheClearanceOfCurvesToOneMillimetre) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const CollisionScene scene(support::random_city(seed, 60, 60), {"box", {0.5, 0.5, 0.5}}, 0);
    const Trajectory curve = moved(testing::random_trajectory(seed), {0, 0, 70});
    const CheckResult result = check(scene, curve, Limits{});
    ASSERT_TRUE(result.clearance) << name(result.reason);
    const double whole = duration(curve);
    double least = std::numeric_limits<double>::infinity();
    double step = 0;  // the longest between samples
    Vec3 before = evaluate(curve, 0).position;
    constexpr int kSamples = 20000;
    for (int k = 0; k <= kSamples; ++k) {
      const Vec3 p = evaluate(curve, whole * k / kSamples).position;
      least = std::min(least, scene.nearest(p, 1e3)->distance);
      step = std::max(step, (p - before).norm());
      before = p;
    }
    EXPECT_LE(result.clearance->value, least + 1e-3) << "seed " << seed;
    EXPECT_GE(result.clearance->value, least - step) << "seed " << seed;
  }
}

TEST(Check, LeavesTheClearanceOutWhereItIsNotAskedFor) {
  const Trajectory line = {{hermite(rest({-10, 4, 0}), rest({10, 4, 0}), 8)}};
  CheckOptions options;
  options.clearance = Clearance::left_out;
  EXPECT_TRUE(check(cube(), line, options).ok);
  EXPECT_FALSE(check(cube(), line, options).clearance);
  const std::vector<Vec3> path = {{-10, 4, 0}, {10, 4, 0}};
  EXPECT_TRUE(check_path(cube(), path).clearance);
  EXPECT_FALSE(check_path(cube(), path, {}, Clearance::left_out).clearance);
}

}  // namespace
}  // namespace traj
