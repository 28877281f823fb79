#include "traj/home/return_places.h"

#include <gtest/gtest.h>

namespace traj {
namespace {

using Indices = std::vector<std::size_t>;

FlightStage stage_at(double x) {
  FlightStage out;
  out.where = {{x, 0, 30}};
  return out;
}

ReturnPlace rally_at(double x) { return {{x, 0, 0}, 20}; }
const ReturnPlace kHome{{0, 0, 0}};

// A model without what a firmware may be off its way.
ReturnModel sharp(const Autopilot& autopilot) {
  ReturnModel out = return_model(autopilot);
  out.around = Vec3::Zero();
  return out;
}

TEST(LikelyPlaces, AreTheNearestAndThoseThatPx4CountsAsNoFurther) {
  const ReturnModel model = sharp(px4("1.17"));
  const std::vector<ReturnPlace> places{rally_at(100), kHome};
  EXPECT_EQ(likely_places(model, stage_at(48.9), places), Indices{1});
  EXPECT_EQ(likely_places(model, stage_at(50), places), (Indices{0, 1}));
  EXPECT_EQ(likely_places(model, stage_at(50.9), places), (Indices{0, 1})) << "2 m further";
  EXPECT_EQ(likely_places(model, stage_at(51.1), places), Indices{0});
}

TEST(LikelyPlaces, GrowByWhatTheVehicleMayBeOff) {
  ReturnModel model = sharp(px4("1.17"));
  model.around = {3, 4, 0};  // so that both distances may be 5 m wrong
  const std::vector<ReturnPlace> places{rally_at(100), kHome};
  EXPECT_EQ(likely_places(model, stage_at(44.5), places), (Indices{0, 1}));
  EXPECT_EQ(likely_places(model, stage_at(43.5), places), Indices{1});
}

TEST(LikelyPlaces, MayBeHomeWhereARallyPointIsTooNearToIt) {
  const std::vector<ReturnPlace> places{rally_at(8), kHome};
  EXPECT_EQ(likely_places(sharp(px4("1.17")), stage_at(60), places), (Indices{0, 1}));
  EXPECT_EQ(likely_places(sharp(ardupilot()), stage_at(60), places), Indices{0});
}

TEST(LikelyPlaces, OfPx4111MayBeAnyForItComparesDegrees) {
  const std::vector<ReturnPlace> places{rally_at(500), kHome};
  EXPECT_EQ(likely_places(sharp(px4("1.11")), stage_at(5), places), (Indices{0, 1}));
}

TEST(LikelyPlaces, OfArduPilotAreHomeBeyondTheLimitOfRallyPoints) {
  const std::vector<ReturnPlace> places{rally_at(500), kHome};
  EXPECT_EQ(likely_places(sharp(ardupilot()), stage_at(700), places), Indices{0});
  EXPECT_EQ(likely_places(sharp(ardupilot()), stage_at(900), places), (Indices{0, 1}));
}

TEST(LikelyPlaces, OfArduPilotAreRallyPointsAloneIfHomeIsNone) {
  Autopilot autopilot = ardupilot();
  autopilot.home_is_a_place = false;
  const std::vector<ReturnPlace> places{rally_at(200), kHome};
  EXPECT_EQ(likely_places(sharp(autopilot), stage_at(5), places), Indices{0});
  EXPECT_EQ(likely_places(sharp(autopilot), stage_at(-150), places), (Indices{0, 1}))
      << "350 m, beyond the limit";
  EXPECT_EQ(likely_places(sharp(autopilot), stage_at(5), {kHome}), Indices{0});
}

TEST(LikelyPlaces, AreAllThatAreNearerThanHomeIfAFenceMayExcludeSome) {
  ReturnModel model = sharp(ardupilot());
  model.fence_excludes = true;
  const std::vector<ReturnPlace> places{rally_at(200), rally_at(180), rally_at(-190), kHome};
  EXPECT_EQ(likely_places(model, stage_at(150), places), (Indices{0, 1, 3}));
}

TEST(LikelyPlaces, OfAPartOfAStageAreAmongThoseOfTheStage) {
  const std::vector<ReturnPlace> places{rally_at(100), rally_at(-120), rally_at(9), kHome};
  for (const ReturnModel& model : {return_model(px4("1.17")), return_model(ardupilot())}) {
    FlightStage whole;
    whole.where = {{-80, 3, 20}, {90, -7, 25}};
    const Indices all = likely_places(model, whole, places);
    for (const FlightStage& part : {halves(whole)->first, halves(whole)->second}) {
      for (const std::size_t i : likely_places(model, part, places)) {
        EXPECT_TRUE(std::find(all.begin(), all.end(), i) != all.end());
      }
    }
  }
}

}  // namespace
}  // namespace traj
