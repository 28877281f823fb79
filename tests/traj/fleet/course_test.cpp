#include "fleet/course.h"

#include <gtest/gtest.h>

#include "traj/fleet/random_flights.h"

namespace traj {
namespace {

using testing::place_at;
using testing::random_flight;

TEST(Course, HoldsTheFlightAtEveryInstant) {
  geom::SplitMix64 random(1);
  for (int k = 0; k < 200; ++k) {
    const Trajectory flight = random_flight(random);
    const Course course = course_of(flight, Parked::gone, {0.1, 0.03});
    double last = 0;
    for (const StraightPiece& piece : course.pieces) {
      EXPECT_NEAR(piece.begin, last, 1e-9) << "no time is left out";
      last = piece.end;
      for (int i = 0; i <= 20; ++i) {
        const double u = i / 20.0;
        const Vec3 off = place_at(flight, piece.begin + u * (piece.end - piece.begin)) -
                         (piece.from + u * piece.way);
        ASSERT_LE(off.head<2>().norm(), piece.off.across + 1e-9) << k;
        ASSERT_LE(std::abs(off.z()), piece.off.up + 1e-9) << k;
        ASSERT_LE(piece.off.across, 0.1 + 1e-6);
      }
    }
    EXPECT_NEAR(last, duration(flight), 1e-9);
  }
}

TEST(Course, StandsForEverOnPads) {
  const Trajectory flight{{hermite({}, {{10, 0, 5}}, 4)}};
  const Course course = course_of(flight, Parked::pad, {0.1, 0.1});
  EXPECT_EQ(course.pieces.front().begin, -std::numeric_limits<double>::infinity());
  EXPECT_EQ(course.pieces.front().end, 0);
  EXPECT_EQ(course.pieces.back().begin, 4);
  EXPECT_EQ(course.pieces.back().from, Vec3(10, 0, 5));
  EXPECT_EQ(course.pieces.back().end, std::numeric_limits<double>::infinity());
}

TEST(Course, CountsWhatSegmentsMissEachOtherBy) {
  Trajectory flight{{hermite({}, {{10, 0, 5}}, 4), hermite({{10.5, 0, 5}}, {{20, 0, 5}}, 4)}};
  for (const StraightPiece& piece : course_of(flight, Parked::gone, {0.1, 0.1}).pieces) {
    EXPECT_GE(piece.off.across, 0.5);
  }
}

TEST(Course, EveryBoxOfTheTreeHoldsItsPieces) {
  geom::SplitMix64 random(2);
  const Course course = course_of(random_flight(random), Parked::pad, {0.05, 0.05});
  for (const CourseNode& node : course.nodes) {
    if (node.left == 0) continue;
    for (const std::uint32_t child : {node.left, node.right}) {
      const CourseBox& box = course.nodes[child].box;
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_LE(node.box.low[i], box.low[i]);
        EXPECT_GE(node.box.high[i], box.high[i]);
      }
      EXPECT_LE(node.box.begin, box.begin);
      EXPECT_GE(node.box.end, box.end);
    }
  }
}

}  // namespace
}  // namespace traj
