#include "traj/check/flight_set.h"

#include <gtest/gtest.h>

#include "support/reading.h"
#include "traj/scenes.h"

namespace traj {
namespace {

const geom::Vehicle kCube{"cube", Vec3::Constant(0.5)};

geom::CollisionScene cube_scene() { return {testing::scene_of({}).map(), kCube, 0}; }

TrajectoryRecord flight(std::string id, const Vec3& from, const Vec3& to) {
  TrajectoryRecord record{.id = std::move(id), .status = TrajectoryStatus::solved};
  record.trajectory.segments = {hermite({from}, {to}, 10)};
  return record;
}

TEST(FlightSet, FindsFlightsThatCrossAndAcceptsThoseThatKeepApart) {
  const auto scene = cube_scene();
  FlightSet apart(TogetherRule{});
  apart.add(flight("a", {0, 0, 5}, {9, 0, 5}), &scene, "f", 1);
  apart.add(flight("b", {0, 4, 5}, {9, 4, 5}), &scene, "f", 2);
  EXPECT_TRUE(apart.check().ok());
  EXPECT_EQ(apart.task().ids, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(apart.task().map, scene.map().hash());
  FlightSet crossing(TogetherRule{});
  crossing.add(flight("a", {0, 0, 5}, {9, 0, 5}), &scene, "f", 1);
  crossing.add(flight("b", {9, 0, 5}, {0, 0, 5}), &scene, "f", 2);
  EXPECT_EQ(crossing.check(true).refused.size(), 1u);
}

TEST(FlightSet, LeavesOutWhatHoldsNoTrajectory) {
  FlightSet set(TogetherRule{});
  set.add({.id = "a", .status = TrajectoryStatus::no_path}, nullptr, "f", 1);
  EXPECT_EQ(set.left_out(), 1u);
  EXPECT_TRUE(set.flights().empty());
}

TEST(FlightSet, RefusesAnIdThatComesAgain) {
  const auto scene = cube_scene();
  FlightSet set(TogetherRule{});
  set.add(flight("a", {0, 0, 5}, {9, 0, 5}), &scene, "f", 1);
  EXPECT_EQ(support::refusal_of([&] {
              set.add({.id = "a", .status = TrajectoryStatus::no_path}, nullptr, "f", 2);
            }),
            "f:2: expected each id once, found \"a\" again");
}

TEST(FlightSet, RefusesAnotherEpochThanTheFirst) {
  FlightSet set(TogetherRule{});
  TrajectoryRecord record{.id = "a", .status = TrajectoryStatus::no_path};
  record.time.epoch = "2026-05-04T06:30:00Z";
  set.add(record, nullptr, "f", 1);
  record.id = "b";
  record.time.epoch.reset();
  EXPECT_NE(support::refusal_of([&] { set.add(record, nullptr, "f", 2); }), "");
}

TEST(FlightSet, RefusesAFlightThatLacksWhatIsNeeded) {
  const auto point = testing::scene_of({});
  const auto a = flight("a", {0, 0, 5}, {9, 0, 5});
  const auto refusal = [&](const TogetherRule& rule, FlightSet::Needs needs) {
    FlightSet set(rule, needs);
    return support::refusal_of([&] { set.add(a, &point, "f", 1); });
  };
  EXPECT_NE(refusal({}, {}), "");  // a point has no size
  EXPECT_EQ(refusal({.spacing = {cylinder(5, 3), {}}}, {}), "");
  EXPECT_EQ(refusal({}, {.room = false}), "");
  EXPECT_NE(refusal({}, {.room = false, .start = true}), "");
}

TEST(FlightSet, SaysThatAVehicleIsSmallerThanARecordAsksFor) {
  const auto scene = cube_scene();
  FlightSet set(TogetherRule{});
  auto a = flight("a", {0, 0, 5}, {9, 0, 5});
  set.add(a, &scene, "f", 1);
  EXPECT_FALSE(set.task().overridden);
  auto b = flight("b", {0, 4, 5}, {9, 4, 5});
  b.provenance.margin = 1;
  set.add(b, &scene, "f", 2);
  EXPECT_TRUE(set.task().overridden);
}

}  // namespace
}  // namespace traj
