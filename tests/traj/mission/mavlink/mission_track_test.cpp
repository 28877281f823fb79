#include "mission/mavlink/mission_track.h"

#include <gtest/gtest.h>

namespace traj {
namespace {

constexpr FlightPart kLeg{2, Manoeuvre::leg};

Turn pass(double radius) { return {Turn::pass, radius, radius}; }

FlownMission finished(FlownTrack track) {
  FlownMission out;
  track.finish({9, Manoeuvre::landing}, 0, out);
  return out;
}

TEST(FlownTrack, KeepsPointsHoldsAndLegs) {
  FlownTrack track;
  track.go({0, 0, 9}, 0, {1, Manoeuvre::takeoff}, {});
  track.go({50, 0, 9}, 2, kLeg, {});
  track.stay(3);
  const FlownMission out = finished(track);
  EXPECT_EQ(out.path, (geom::Polyline{{0, 0, 9}, {50, 0, 9}}));
  EXPECT_EQ(out.hold, (std::vector<double>{0, 5}));
  EXPECT_EQ(out.legs,
            (std::vector<FlightPart>{{1, Manoeuvre::takeoff}, kLeg, {9, Manoeuvre::landing}}));
  EXPECT_TRUE(out.sweeps.empty());
}

TEST(FlownTrack, SweepsTheWayFromWhereverItLeaves) {
  FlownTrack track;
  track.go({0, 0, 9}, 0, kLeg, {});
  track.leave_from({{0, -5, 9}, {0, 5, 9}});
  EXPECT_FALSE(track.starts_at_point());
  EXPECT_FALSE(track.rests());
  track.go({50, 0, 9}, 0, kLeg, pass(10));
  EXPECT_TRUE(track.starts_at_point());
  const Hull reached = track.reached();
  ASSERT_EQ(reached.size(), 4u);
  EXPECT_EQ(reached[0], Vec3(40, 0, 9));
  EXPECT_LT(reached[1].y(), 0);
  EXPECT_GT(reached[2].y(), 0);
  EXPECT_EQ(reached[3], Vec3(50, 0, 9));
  const FlownMission out = finished(track);
  ASSERT_EQ(out.sweeps.size(), 1u) << "no corner at the end";
  EXPECT_EQ(out.sweeps[0].hull, (Hull{{0, -5, 9}, {0, 5, 9}, {50, 0, 9}}));
}

TEST(FlownTrack, PointsMayCountAsReachedAtOnce) {
  FlownTrack track;
  track.go({0, 0, 9}, 0, kLeg, {});
  track.go({50, 0, 9}, 0, kLeg, pass(10));
  track.go({50, 15, 9}, 0, kLeg, pass(10));
  track.leave_when_reached();
  EXPECT_EQ(track.from_where(), (Hull{{50, 5, 9}, {50, 15, 9}, {40, 0, 9}, {50, 0, 9}}));
  EXPECT_TRUE(track.starts_at_point()) << "taken";
  track.go({50, 40, 9}, 0, kLeg, {});
  EXPECT_EQ(track.reached(), (Hull{{50, 40, 9}, {50, 40, 9}}));
}

TEST(FlownTrack, KnowsTheLargestSpeed) {
  FlownTrack track;
  track.go({0, 0, 9}, 0, kLeg, {});
  EXPECT_EQ(track.most_speed(10), 10);
  track.say_speed(4);
  track.say_speed(3);
  track.go({50, 0, 9}, 0, kLeg, {});
  EXPECT_EQ(track.most_speed(10), 4);
  EXPECT_EQ(finished(track).speed, 4);
  track.say_no_speed();
  EXPECT_EQ(track.most_speed(10), 10);
  EXPECT_EQ(finished(track).speed, std::nullopt);
}

TEST(FlownTrack, KnowsTheLargestSpeedThatMayBe) {
  FlownTrack track;
  track.say_speed(4);
  track.may_fly_at(6, 10);
  track.go({0, 0, 9}, 0, kLeg, {});
  track.go({50, 0, 9}, 0, kLeg, {});
  EXPECT_EQ(finished(track).speed, 6);
  track.may_fly_at_own(10);
  EXPECT_EQ(finished(track).speed, 6) << "nothing was flown since";
  track.go({70, 0, 9}, 0, kLeg, {});
  EXPECT_EQ(finished(track).speed, std::nullopt);
}

}  // namespace
}  // namespace traj
