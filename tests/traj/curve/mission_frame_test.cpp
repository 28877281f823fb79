#include "traj/curve/mission_frame.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"

namespace traj {
namespace {

MissionFrame over_grid() {
  const geom::GeoidGrid grid{.south = 46,
                             .west = 7,
                             .north_step = 1,
                             .east_step = 1,
                             .columns = 2,
                             .rows = 2,
                             .heights = {48, 50, 48, 50},
                             .error = 0.5};
  return {.origin = {46.5, 7.5, 500},
          .geoid = 1,
          .geoid_grid = std::make_shared<const geom::GeoidGrid>(grid)};
}

TEST(MissionFrame, HasOneSeaLevelWithoutAGrid) {
  const MissionFrame frame{.origin = {46.5, 7.5, 500}, .geoid = 49};
  EXPECT_EQ(frame.sea_level(46.5, 7.5), 49);
  EXPECT_EQ(frame.sea_level(-80, 170), 49);
  EXPECT_EQ(frame.sea_error(), 0);
}

TEST(MissionFrame, TakesTheSeaLevelOfTheGridPlaceByPlace) {
  const MissionFrame frame = over_grid();
  EXPECT_NEAR(frame.sea_level(46.3, 7.25), 48.5, 1e-6);
  EXPECT_NEAR(frame.sea_level(46.3, 7.75), 49.5, 1e-6);
  EXPECT_EQ(frame.sea_error(), 0.5);
}

TEST(MissionFrame, RefusesAPlaceThatTheGridDoesNotKnow) {
  EXPECT_THROW(over_grid().sea_level(48, 7.5), geom::InputError);
}

}  // namespace
}  // namespace traj
