#include "traj/together/exact/exact_moving.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "geom/base/error.h"
#include "support/moving_case.h"

namespace traj {
namespace {

using support::Contact;
using support::MovingCase;

ExactMoving check(const MovingCase& c) { return check_moving_exactly(c.flight(), c.box, c.parked); }

Contact any_contact(support::Random& random) {
  return static_cast<Contact>(random.below(support::kContacts));
}

TEST(ExactMoving, CallsNoTouchClear) {
  support::Random random(1);
  for (int i = 0; i < 800; ++i) {
    const double depth = random.below(2) ? 0 : random.stepped(0, 1, 0x1p-31);
    const MovingCase c = support::contact(random, any_contact(random), depth);
    ASSERT_FALSE(moving_box_fault(c.box)) << i;
    const ExactMoving proof = check(c);
    EXPECT_FALSE(proof.clear) << i;
    EXPECT_GE(proof.time, c.box.from) << i;
    EXPECT_LE(proof.time, c.box.until) << i;
  }
}

// Where the fast check leaves room for rounding.
TEST(ExactMoving, AcceptsWhatIsAnyLengthBeyond) {
  support::Random random(2);
  for (int i = 0; i < 800; ++i) {
    EXPECT_TRUE(check(support::contact(random, any_contact(random), -0x1p-31)).clear) << i;
  }
}

TEST(ExactMoving, HasASideForEachPieceAndPiecesForAllOfAStretch) {
  support::Random random(4);
  for (int i = 0; i < 200; ++i) {
    const ExactMoving proof = check(support::contact(random, any_contact(random), -1e-6));
    ASSERT_TRUE(proof.clear);
    for (const MovingCover& cover : proof.stretches) {
      EXPECT_EQ(cover.pieces.size(), cover.sides.size());
      const double sum =
          std::accumulate(cover.pieces.begin(), cover.pieces.end(), 0.0,
                          [](double s, int depth) { return s + std::ldexp(1.0, -depth); });
      EXPECT_EQ(sum, 1);
    }
  }
}

TEST(ExactMoving, RefusesWhatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  support::Random random(5);
  const MovingCase c = support::contact(random, any_contact(random), -1);
  MovingBox box = c.box;
  box.until = nan;
  EXPECT_THROW(check_moving_exactly(c.flight(), box, c.parked), geom::InputError);
  TimedFlight late = c.flight();
  late.start = nan;
  EXPECT_THROW(check_moving_exactly(late, c.box, c.parked), geom::InputError);
}

// Two segments, of which the second begins 3 m beside the end of the first.
Trajectory with_a_step() {
  Trajectory out;
  out.segments.resize(2);
  out.segments[0].duration = out.segments[1].duration = 1;
  out.segments[0].point.fill({0, 0, 0});
  out.segments[1].point.fill({0, 3, 0});
  return out;
}

MovingBox box_around(const Vec3& middle, double from, double until) {
  MovingBox box;
  box.box = {middle - Vec3::Constant(0.5), middle + Vec3::Constant(0.5)};
  box.from = from;
  box.until = until;
  return box;
}

TEST(ExactMoving, TakesTheStepBetweenSegmentsAsFlown) {
  const Trajectory flight = with_a_step();
  const MovingBox box = box_around({0, 1.5, 0}, -5, 5);
  EXPECT_FALSE(check_moving_exactly({&flight, 0, Vec3::Zero()}, box, Parked::gone).clear);
  EXPECT_FALSE(check_moving({&flight, 0, Vec3::Zero()}, box, Parked::gone).clear);
}

// All time in which both are there, cut at joints.
TEST(ExactMoving, HasAStretchBetweenJoints) {
  Trajectory flight = with_a_step();
  flight.segments[1].point.fill({0, 0, 0});
  const auto stretches = [&](double from, double until, Parked parked) {
    const MovingBox box = box_around({0, 9, 0}, from, until);
    const ExactMoving proof = check_moving_exactly({&flight, 10, Vec3::Zero()}, box, parked);
    EXPECT_TRUE(proof.clear);
    return proof.stretches.size();
  };
  EXPECT_EQ(stretches(0, 20, Parked::pad), 4u);
  EXPECT_EQ(stretches(0, 20, Parked::gone), 2u);
  EXPECT_EQ(stretches(10.5, 10.75, Parked::pad), 1u);
  EXPECT_EQ(stretches(12, 13, Parked::gone), 1u);  // the last instant
  EXPECT_EQ(stretches(12.1, 13, Parked::gone), 0u);
  EXPECT_EQ(stretches(12.1, 13, Parked::pad), 1u);
}

// The double 0.1 + 0.2 is 2.8e-17 above the sum of the two doubles.
TEST(ExactMoving, AddsSpeedAndGrowthAsFractions) {
  Trajectory flight;
  flight.segments.resize(1);
  flight.segments[0].duration = 1;
  MovingBox box = box_around({0, 0, 0}, 0, 1);
  box.velocity.x() = 0.1;
  box.growth.x() = 0.2;
  const auto is_clear = [&](double x) {
    flight.segments[0].point.fill({x, 0, 0});
    return check_moving_exactly({&flight, 0, Vec3::Zero()}, box, Parked::gone).clear;
  };
  EXPECT_TRUE(is_clear(0.5 + (0.1 + 0.2)));
  EXPECT_FALSE(is_clear(0.5 + (0.1 + 0.2) - 0x1p-53));
}

}  // namespace
}  // namespace traj
