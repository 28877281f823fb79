#include "traj/together/moving_box.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geom/base/error.h"
#include "traj/scenes.h"

namespace traj {
namespace {

using testing::straight;

MovingBox still_box(double from = 0, double until = 100) {
  MovingBox box;
  box.box = {Vec3(10, -1, -1), Vec3(12, 1, 1)};
  box.from = from;
  box.until = until;
  return box;
}

MovingResult check_of(const Trajectory& flight, const MovingBox& box, double start = 0,
                      Parked parked = Parked::gone, const Vec3& room = Vec3::Zero()) {
  return check_moving({&flight, start, room}, box, parked);
}

TEST(MovingBox, IsThereFromItsFirstInstantToItsLast) {
  // At x = 10 after 10 s, at 12 after 12.
  const Trajectory flight = straight({0, 0, 0}, {32, 0, 0}, 32);
  EXPECT_FALSE(check_of(flight, still_box(0, 10)).clear);
  EXPECT_FALSE(check_of(flight, still_box(12, 20)).clear);
  EXPECT_TRUE(check_of(flight, still_box(0, 9.999999)).clear);
  EXPECT_TRUE(check_of(flight, still_box(12.000001, 20)).clear);
  EXPECT_TRUE(check_of(flight, still_box(-50, -1)).clear);
  EXPECT_TRUE(check_of(flight, still_box(40, 50)).clear);
  const MovingResult result = check_of(flight, still_box());
  EXPECT_GE(result.time, 9.99);
  EXPECT_LE(result.time, 12.01);
  EXPECT_NEAR(result.place.x(), result.time, 1e-9);
}

TEST(MovingBox, GoesAndGrows) {
  const Trajectory hover = straight({40, 0, 0}, {40, 0, 0}, 10);
  MovingBox box = still_box(0, 10);
  box.velocity = {2.8, 0, 0};
  EXPECT_FALSE(check_of(hover, box).clear);  // it touches at the last instant
  box.velocity = {2.7999999, 0, 0};
  EXPECT_TRUE(check_of(hover, box).clear);
  box.growth = {0.0000002, 0, 0};
  EXPECT_FALSE(check_of(hover, box).clear);
  box.velocity = {2, 0, 0};
  box.growth = {0.8, 0, 0};
  EXPECT_FALSE(check_of(hover, box).clear);
  box.until = 9.999;
  EXPECT_TRUE(check_of(hover, box).clear);
  box.growth = {0, 0, 9};  // along another axis
  EXPECT_TRUE(check_of(hover, box).clear);
}

TEST(MovingBox, IsKeptClearOfByTheWholeRoom) {
  const Trajectory flight = straight({0, 3, 0}, {32, 3, 0}, 32);
  EXPECT_TRUE(check_of(flight, still_box(), 0, Parked::gone, {0.5, 1.999999, 0.5}).clear);
  EXPECT_FALSE(check_of(flight, still_box(), 0, Parked::gone, {0.5, 2, 0.5}).clear);
}

TEST(MovingBox, MeetsWhatStandsOnItsPad) {
  const Trajectory flight = straight({11, 0, 0}, {31, 0, 0}, 10);
  // There before the departure only.
  EXPECT_TRUE(check_of(flight, still_box(0, 5), 20).clear);
  EXPECT_FALSE(check_of(flight, still_box(0, 5), 20, Parked::pad).clear);
  const Trajectory arrival = straight({31, 0, 0}, {11, 0, 0}, 10);
  EXPECT_TRUE(check_of(arrival, still_box(50, 60), 20).clear);
  const MovingResult result = check_of(arrival, still_box(50, 60), 20, Parked::pad);
  EXPECT_FALSE(result.clear);
  EXPECT_EQ(result.place, Vec3(11, 0, 0));
  EXPECT_TRUE(check_of(flight, still_box(50, 60), 20, Parked::pad).clear);
}

TEST(MovingBox, CatchesUpWithAFlight) {
  // Behind it, faster by a metre a second.
  const Trajectory flight = straight({20, 0, 0}, {120, 0, 0}, 10);
  MovingBox box = still_box(0, 8);
  box.velocity = {11, 0, 0};
  EXPECT_FALSE(check_of(flight, box).clear);  // 12 + 88 = 20 + 80
  box.until = 7.999999;
  EXPECT_TRUE(check_of(flight, box).clear);
}

TEST(MovingBox, RefusesWhatIsNone) {
  EXPECT_FALSE(moving_box_fault(still_box()));
  const auto fault = [](auto change) {
    MovingBox box = still_box();
    change(box);
    return moving_box_fault(box).has_value();
  };
  EXPECT_TRUE(fault([](MovingBox& b) { b.box.min.x() = 12.1; }));
  EXPECT_TRUE(fault([](MovingBox& b) { b.box.min.x() = std::nan(""); }));
  EXPECT_TRUE(fault([](MovingBox& b) { b.velocity.y() = INFINITY; }));
  EXPECT_TRUE(fault([](MovingBox& b) { b.growth.z() = -1e-9; }));
  EXPECT_TRUE(fault([](MovingBox& b) { b.until = 0; }));
  EXPECT_TRUE(fault([](MovingBox& b) { b.from = 1e-12; }));
  EXPECT_TRUE(fault([](MovingBox& b) { b.until = 1e10; }));
  EXPECT_TRUE(fault([](MovingBox& b) { b.until = 1e9, b.velocity.x() = 1; }));
}

TEST(MovingBox, ThatIsNoneIsNotKeptClearOf) {
  const Trajectory line = testing::straight({0, 0, 0}, {80, 0, 0}, 8);
  const auto check = [&](auto change, double start) {
    MovingBox box = still_box();
    change(box);
    return check_moving({&line, start, Vec3::Zero()}, box, Parked::gone);
  };
  EXPECT_THROW(check([](MovingBox& b) { b.from = std::nan(""); }, 0), geom::InputError);
  EXPECT_THROW(check([](MovingBox& b) { std::swap(b.box.min, b.box.max); }, 0), geom::InputError);
  EXPECT_THROW(check([](MovingBox&) {}, std::nan("")), geom::InputError);
}

}  // namespace
}  // namespace traj
