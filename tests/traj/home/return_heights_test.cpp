#include "traj/home/return_heights.h"

#include <gtest/gtest.h>

namespace traj {
namespace {

ReturnModel with(const Autopilot& autopilot, double acceptance, double slope, double near) {
  Autopilot out = autopilot;
  out.acceptance = acceptance;
  out.return_slope = slope;
  out.return_near = near;
  return return_model(out);
}

double at(const ReturnModel& model, double away) {
  const HeightRange range = return_heights(model, 30, away, away);
  EXPECT_LE(range.least, range.most) << away;
  return range.most;
}

TEST(ReturnHeights, OfPx4AreTwiceTheDistanceWithinTheAcceptanceAndTheConeWithinItsRadius) {
  const ReturnModel model = with(px4("1.17"), 4, 1, 20);
  EXPECT_EQ(at(model, 0), 0);
  EXPECT_EQ(at(model, 3), 6);
  EXPECT_EQ(at(model, 5), 8) << "twice the acceptance at least";
  EXPECT_EQ(at(model, 15), 15);
  EXPECT_EQ(at(model, 20.5), 30);
  EXPECT_EQ(return_heights(model, 30, 20.5, 20.5).least, 30);
}

TEST(ReturnHeights, AreNoLowerForPx4sWithASmallerRadius) {
  const ReturnModel large = with(px4("1.17"), 10, 1, 20);
  for (double radius = 1; radius <= 10; ++radius) {
    for (double away = 0; away < 30; away += 0.5) {
      const ReturnModel small = with(px4("1.17"), radius, 1, 20);
      EXPECT_LE(return_heights(large, 30, away, away).least, at(small, away));
      EXPECT_GE(at(large, away), at(small, away) - 1e-12);
    }
  }
}

TEST(ReturnHeights, GrowWithTheDistance) {
  for (const ReturnModel& model : {return_model(px4()), return_model(px4("1.11")),
                                   return_model(px4("1.16")), return_model(ardupilot())}) {
    HeightRange before;
    for (double away = 0; away < 100; away += 0.25) {
      const HeightRange range = return_heights(model, 30, away, away);
      EXPECT_GE(range.least, before.least) << model.autopilot << away;
      EXPECT_GE(range.most, before.most) << model.autopilot << away;
      before = range;
    }
  }
}

TEST(ReturnHeights, OfAllVersionsHoldThoseOfEach) {
  const ReturnModel all = return_model(px4());
  for (const char* version : {"1.11", "1.12", "1.15", "1.16", "1.17"}) {
    for (double away = 0; away < 100; away += 0.25) {
      const HeightRange one = return_heights(return_model(px4(version)), 12, away, away + 1);
      const HeightRange range = return_heights(all, 12, away, away + 1);
      EXPECT_LE(range.least, one.least) << version << away;
      EXPECT_GE(range.most, one.most) << version << away;
    }
  }
}

TEST(ReturnHeights, OfPx4MayBeTwiceTheAcceptanceAboveALowReturnUntil115) {
  EXPECT_EQ(return_heights(return_model(px4("1.15")), 12, 50, 50).most, 20);
  EXPECT_EQ(return_heights(return_model(px4("1.16")), 12, 50, 50).most, 12);
}

TEST(ReturnHeights, OfPx4111AreThatOfTheDescentNearItsPlace) {
  const ReturnModel model = with(px4("1.11"), 2, 1, 10);
  EXPECT_EQ(at(model, 0), 10);
  EXPECT_EQ(at(model, 9), 10);
  EXPECT_EQ(at(model, 17), 17) << "the cone from anywhere";
}

TEST(ReturnHeights, OfArduPilotAreTheConeFromAnywhereUnlessItIsFlat) {
  EXPECT_EQ(at(with(ardupilot(), 2, 3, 0), 4), 12);
  EXPECT_EQ(at(with(ardupilot(), 2, 3, 0), 40), 30);
  EXPECT_EQ(at(with(ardupilot(), 2, 0.4, 0), 4), 30);
  EXPECT_EQ(at(with(ardupilot(), 2, 0, 0), 4), 30);
}

TEST(ReturnHeights, OfDjiMayBeAnyNearHome) {
  const HeightRange near = return_heights(dji_return_model(60), 60, 49, 49);
  EXPECT_EQ(near.least, 0);
  EXPECT_EQ(near.most, 60);
  EXPECT_EQ(return_heights(dji_return_model(60), 60, 51, 51).least, 60);
}

}  // namespace
}  // namespace traj
