#include "plan/planner/moved_ends.h"

#include <gtest/gtest.h>

#include "plan/scenes.h"

namespace plan {
namespace {

const geom::Aabb kCube{{0, 0, 0}, {40, 40, 40}};

TEST(MovedEnds, SayWhyHowFarAndWhereTo) {
  const auto scene = scene_of({{{10, 10, 0}, {20, 20, 8}}}, kCube);
  const geom::PlanQuery query{.id = "q1", .from = {11, 15, 4}, .to = {41, 15, 4}};
  PlanResult result;
  EXPECT_TRUE(moved_ends(scene, query, result).empty());
  result.snapped_start = Vec3(9, 15, 4);
  result.snapped_goal = Vec3(39, 15, 4);
  const auto said = moved_ends(scene, query, result);
  ASSERT_EQ(said.size(), 2u);
  EXPECT_EQ(
      said[0],
      "q1: the start was inside an obstacle and was moved 2.000 m, to (9.000, 15.000, 4.000)");
  EXPECT_EQ(
      said[1],
      "q1: the goal was outside the bounds and was moved 2.000 m, to (39.000, 15.000, 4.000)");
}

TEST(MovedEnds, SayThatThereIsLittleRoom) {
  const auto scene = scene_of({{{10, 10, 0}, {20, 20, 8}}}, kCube);
  const geom::PlanQuery query{.id = "q1", .from = {11, 15, 4}, .to = {30, 15, 4}};
  PlanResult result;
  result.snapped_start = Vec3(9.99, 15, 4);
  EXPECT_NE(moved_ends(scene, query, result)[0].find("less than 0.03 m to spare"),
            std::string::npos);
}

}  // namespace
}  // namespace plan
