#include "traj/proof/exact/exact_check.h"

#include <gtest/gtest.h>

#include <limits>

#include "geom/base/error.h"
#include "proof/exact/gmp_bernstein.h"
#include "support/random_city.h"
#include "traj/proof/check.h"
#include "traj/record/certificate_record.h"
#include "traj/scenes.h"

namespace traj {
namespace {

using geom::CollisionScene;
using testing::arc;
using testing::one_box;
using testing::rest;

ExactResult exactly(const CollisionScene& scene, const Trajectory& t, const Limits& limits = {}) {
  return check_exactly({scene.map(), scene.vehicle(), scene.margin(), limits}, t);
}

// A cube of 2 m in the middle, and a vehicle of 1 m.
const CollisionScene& cube() {
  static const CollisionScene made(one_box(), {"box", {0.5, 0.5, 0.5}}, 0);
  return made;
}

double length_of(const Cover& cover) {
  double sum = 0;
  for (const int depth : cover) sum += std::ldexp(1, -depth);
  return sum;
}

TEST(Whole, HoldsEveryDouble) {
  using exact::whole;
  EXPECT_EQ(whole(1.0), mpz_class(1) << 1074);
  EXPECT_EQ(whole(-0.75), -3 * (mpz_class(1) << 1072));
  EXPECT_EQ(whole(std::numeric_limits<double>::denorm_min()), 1);
  EXPECT_EQ(whole(0.0), 0);
  support::Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const double x = std::ldexp(random.uniform(-1, 1), random.below(2000) - 1040);
    EXPECT_EQ(mpq_class(whole(x)), mpq_class(x) * (mpz_class(1) << 1074));
  }
}

TEST(ExactCheck, AsksForYawInAllSegmentsWhereItsRateIsLimited) {
  const CollisionScene scene(one_box(), {"box", {0.5, 0.5, 0.5}}, 0.1);
  Trajectory t = arc({0, 8, 0}, {3, 0, 0});
  const Limits limits{{Limit::yaw_rate, 100}};
  EXPECT_TRUE(exactly(scene, t, limits).ok) << "no yaw at all";
  t.segments[1].yaw = {0, 0, 0, 0, 0, 0, 0, 0};
  EXPECT_EQ(exactly(scene, t, limits).reason, unmeasured(Limit::yaw_rate));
  EXPECT_TRUE(exactly(scene, t).ok);
}

TEST(ExactCheck, CoversEverySegmentOnce) {
  const CollisionScene scene(one_box(), {"box", {0.5, 0.5, 0.5}}, 0.1);
  const ExactResult result =
      exactly(scene, arc({0, 8, 0}, {3, 0, 0}), {{Limit::speed, 9}, {Limit::acceleration, 20}});
  ASSERT_TRUE(result.ok) << name(result.reason);
  ASSERT_EQ(result.segments.size(), 2u);
  for (const SegmentProof& proof : result.segments) {
    EXPECT_EQ(length_of(proof.clear.pieces), 1);
    EXPECT_EQ(length_of(proof.bounds), 1);
    EXPECT_EQ(length_of(proof.limits[Limit::speed]), 1);
    EXPECT_EQ(length_of(proof.limits[Limit::acceleration]), 1);
    EXPECT_TRUE(proof.limits[Limit::jerk].empty());
    EXPECT_FALSE(proof.gap);
  }
}

TEST(ExactCheck, AcceptsWhatTheFastCheckAccepts) {
  const CollisionScene scene(support::random_city(63, 80, 150), {"box", {0.7, 0.7, 0.3}}, 0.2);
  support::Random random(64);
  int accepted = 0;
  int refused = 0;
  for (int i = 0; i < 1500; ++i) {
    const Vec3 middle(random.uniform(-75, 75), random.uniform(-75, 75), random.uniform(0, 100));
    const Vec3 velocity(random.uniform(-5, 5), random.uniform(-5, 5), random.uniform(-2, 2));
    const Trajectory t = arc(middle, velocity);
    const CheckResult loose = check(scene, t, Limits{});
    const auto near = [&](const std::optional<Extreme>& measured) {
      const Extreme& e = *measured;
      return e.value * (1 + random.uniform(-1, 4) * 1e-4);
    };
    const Limits limits{{Limit::speed, near(loose.largest[Limit::speed])},
                        {Limit::acceleration, near(loose.largest[Limit::acceleration])},
                        {Limit::jerk, near(loose.largest[Limit::jerk])},
                        {Limit::tilt, 0.3 + random.uniform(0, 1)},
                        {Limit::horizontal_speed, near(loose.largest[Limit::speed])},
                        {Limit::vertical_speed, 1 + random.uniform(0, 9)},
                        {Limit::thrust, 10 + random.uniform(0, 30)},
                        {Limit::body_rate, near(loose.largest[Limit::body_rate])}};
    const CheckResult fast = check(scene, t, limits);
    const ExactResult result = exactly(scene, t, limits);
    EXPECT_GE(result.ok, fast.ok) << "case " << i << ": " << name(result.reason);
    if (!result.ok) {
      EXPECT_EQ(result.reason, fast.reason) << "case " << i;
    }
    accepted += result.ok;
    refused += !result.ok;
  }
  EXPECT_GT(accepted, 100);
  EXPECT_GT(refused, 100);
}

TEST(ExactCheck, AllowsALimitToBeReached) {
  const Trajectory line{{hermite(rest({-10, 4, 0}), rest({10, 4, 0}), 8)}};
  const double most = 20.0 / 8 * 35 / 16;  // at the middle, exactly
  EXPECT_TRUE(exactly(cube(), line, {{Limit::speed, most}}).ok);
  const ExactResult over = exactly(cube(), line, {{Limit::speed, std::nextafter(most, 0)}});
  EXPECT_EQ(over.reason, broken(Limit::speed));
  EXPECT_EQ(over.time, 4);
  EXPECT_FALSE(over.undecided);
}

TEST(ExactCheck, SeesGapsJumpsBoundsAndDurations) {
  Trajectory t = arc({0, 20, 0}, {3, 0, 0});
  EXPECT_TRUE(exactly(cube(), t).ok);
  Trajectory gap = t;
  for (Vec3& p : gap.segments[1].point) p.x() += 0x1p-31;
  const ExactResult small = exactly(cube(), gap);
  EXPECT_TRUE(small.ok) << name(small.reason);
  EXPECT_TRUE(small.segments[0].gap);
  EXPECT_EQ(small.joints[0], "1/2147483648");
  for (Vec3& p : gap.segments[1].point) p.x() += 1e-6;
  EXPECT_EQ(exactly(cube(), gap).reason, Reason::discontinuous);
  Trajectory jump = t;
  jump.segments[1].duration = 3;
  EXPECT_EQ(exactly(cube(), jump).reason, Reason::discontinuous);
  EXPECT_EQ(exactly(cube(), arc({0, 48, 0}, {3, 0, 0})).reason, Reason::bounds);
  t.segments[0].duration = 0;
  EXPECT_EQ(exactly(cube(), t).reason, Reason::duration);
  EXPECT_EQ(exactly(cube(), Trajectory{}).reason, Reason::duration);
}

TEST(ExactCheckOfPaths, DecidesEveryLeg) {
  support::Random random(65);
  int free = 0;
  const CollisionScene scene(support::random_city(66, 80, 150), {"box", {0.75, 0.75, 0.25}}, 0.25);
  for (int i = 0; i < 1000; ++i) {
    const auto point = [&] {
      return Vec3(random.stepped(-70, 70, 1), random.stepped(-70, 70, 1), random.stepped(1, 60, 1));
    };
    const std::vector<Vec3> path{point(), point()};
    const bool fast = check_path(scene, path).ok;
    const ExactResult result =
        check_exactly({scene.map(), scene.vehicle(), scene.margin(), {}}, path);
    EXPECT_EQ(result.ok, fast) << "case " << i;  // on whole metres nothing is nearly touching
    EXPECT_FALSE(result.undecided);
    free += fast;
  }
  EXPECT_GT(free, 100);
}

TEST(ExactCheckOfPaths, TouchesAnEdgeButNotItsNeighbour) {
  const auto passing = [&](double y) {  // the grown box has an edge at (1.5, 1.5)
    const std::vector<Vec3> path{{0, y, 0}, {y, 0, 0}};
    return check_exactly({cube().map(), cube().vehicle(), 0, {}}, path);
  };
  EXPECT_EQ(passing(3).reason, Reason::collision);
  EXPECT_TRUE(passing(std::nextafter(3, 4)).ok);
  EXPECT_EQ(check_exactly({cube().map(), cube().vehicle(), 0, {}}, std::span<const Vec3>()).reason,
            Reason::no_path);
}

TEST(ExactCheckOfPaths, MayTouchTheBoundsAndBeOnePoint) {
  const CollisionScene scene(one_box(), {"box", {0.5, 0.5, 0.5}}, 0.125);
  const auto at = [&](double y) {
    const std::vector<Vec3> path{{9, y, 9}};
    return check_exactly({scene.map(), scene.vehicle(), scene.margin(), {}}, path);
  };
  EXPECT_TRUE(at(49.375).ok);
  EXPECT_EQ(at(std::nextafter(49.375, 50)).reason, Reason::bounds);
}

TEST(ExactCheck, FollowsACurveThatStandsStill) {
  const auto still = [&](double x) {
    return exactly(cube(), {{hermite(rest({x, 0, 0}), rest({x, 0, 0}), 2)}},
                   {{Limit::speed, 1e-9}});
  };
  EXPECT_TRUE(still(std::nextafter(1.5, 2)).ok);
  EXPECT_EQ(still(1.5).reason, Reason::collision);
  EXPECT_FALSE(still(1.5).undecided);
}

TEST(ExactCheck, RefusesAStartThatIsNoNumber) {
  const std::vector<Vec3> path{{0, 4, 0}, {4, 0, 0}};
  ExactTask task{cube().map(), cube().vehicle(), 0, {}};
  task.start = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(check_exactly(task, path), geom::InputError);
}

TEST(CertificateRecord, ListsPiecesAndPlanes) {
  const std::vector<Vec3> path{{0, 4, 0}, {4, 0, 0}};
  const ExactResult proof = check_exactly({cube().map(), cube().vehicle(), 0, {}}, path);
  const std::string line =
      to_json_line(CertificateRecord{"a", "path", proof, cube().map().spec().bounds, {}, {}});
  EXPECT_EQ(
      line,
      "{\"type\":\"certificate\",\"id\":\"a\",\"of\":\"path\",\"bounds\":[[-50,-50,-50],"
      "[50,50,50]],\"segments\":[{\"clear\":[0],\"planes\":[[0,0,\"-z\"]],\"bounds\":[0]}]}\n");
}

}  // namespace
}  // namespace traj
