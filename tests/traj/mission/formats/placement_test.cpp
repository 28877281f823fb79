#include "traj/mission/formats/placement.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "geom/base/usage_error.h"
#include "support/reading.h"

namespace traj {
namespace {

constexpr geom::GeodeticOrigin kOrigin{47, 8, 400};

TEST(Placement, GoesBeforeTheMapsOrigin) {
  geom::Frame frame;
  frame.origin = geom::GeodeticOrigin{1, 2, 3};
  Placement placement;
  placement.geoid = 50;
  EXPECT_EQ(placement.mission_frame(frame).origin.latitude, 1);
  EXPECT_EQ(placement.mission_frame(frame).geoid, 50);
  placement.origin = kOrigin;
  EXPECT_EQ(placement.mission_frame(frame).origin.latitude, 47);
  EXPECT_TRUE(placement.mission_frame(frame).height_known);
}

TEST(Placement, ThatNobodyKnowsIsWrongUsage) {
  EXPECT_THROW(Placement().mission_frame({}), geom::UsageError);
  geom::Frame projected;
  projected.crs = "EPSG:31256";
  Placement placement;
  placement.origin = kOrigin;
  EXPECT_THROW(placement.mission_frame(projected), geom::UsageError);
}

TEST(RequireNearOrigin, RefusesBeyond200Kilometres) {
  EXPECT_NO_THROW(require_near_origin({{2e5, 0, 0}, {0, 0, 9e5}}, kOrigin, "q1"));
  EXPECT_EQ(support::refusal_of([] {
              require_near_origin({{0, 200001, 0}}, kOrigin, "q1");
            }),
            "q1: expected a flight within 200 km of the origin, latitude 47, longitude 8, found "
            "[0, 200001] m from it: give the origin from which the map's coordinates count");
}

}  // namespace
}  // namespace traj
