#include "mission/mavlink/mission_jumps.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/reading.h"

namespace traj {
namespace {

MissionItem item(std::size_t number, int command = kWaypoint, double to = 0, double times = 0) {
  MissionItem out;
  out.command = command;
  out.param = {to, times, 0, 0};
  out.number = number;
  return out;
}

std::vector<std::size_t> order(std::vector<MissionItem> items) {
  Mission mission;
  mission.items = std::move(items);
  std::size_t endless = 0;
  return flown_order(mission, "m", endless);
}

std::size_t endless_jumps(std::vector<MissionItem> items) {
  Mission mission;
  mission.items = std::move(items);
  std::size_t endless = 0;
  flown_order(mission, "m", endless);
  return endless;
}

std::string refusal(std::vector<MissionItem> items) {
  return support::refusal_of([&] { order(std::move(items)); });
}

using Order = std::vector<std::size_t>;

TEST(FlownOrder, TakesJumpsAsOftenAsTheySay) {
  EXPECT_EQ(order({item(1), item(2)}), (Order{0, 1}));
  EXPECT_EQ(order({item(1), item(2), item(3, kJump, 1, 2), item(4)}), (Order{0, 1, 0, 1, 0, 1, 3}));
  EXPECT_EQ(order({item(1), item(2, kJump, 1, 0), item(3)}), (Order{0, 2})) << "never";
  EXPECT_EQ(order({item(1), item(2, kJump, 4, 1), item(3), item(4)}), (Order{0, 3})) << "ahead";
}

TEST(FlownOrder, CountsAJumpWithinALoopOnce) {
  EXPECT_EQ(order({item(1), item(2, kJump, 1, 1), item(3), item(4, kJump, 1, 1)}),
            (Order{0, 0, 2, 0, 2}));
}

TEST(FlownOrder, TakesAJumpForEverTwiceAndSaysSo) {
  EXPECT_EQ(order({item(1), item(2, kJump, 1, -1), item(3)}), (Order{0, 0, 0, 2}));
  EXPECT_EQ(endless_jumps({item(1), item(2, kJump, 1, -1), item(3)}), 1u);
  EXPECT_EQ(endless_jumps({item(1), item(2, kJump, 1, 5), item(3)}), 0u);
}

TEST(FlownOrder, RefusesWhatLeadsNowhere) {
  EXPECT_EQ(refusal({item(1), item(2, kJump, 7, 1)}),
            "m: item 2: expected a jump to an item, found one to 7");
  EXPECT_EQ(refusal({item(1), item(2, kJump, 1.5, 1)}),
            "m: item 2: expected a jump to an item, found one to 1.5");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal({item(1), item(2, kJump, nan, 1)}),
            "m: item 2: expected a jump to an item, found one to nan");
  EXPECT_EQ(refusal({item(1), item(2, kJump, 1, nan)}),
            "m: item 2: expected a jump taken a whole number of times, found nan");
  EXPECT_EQ(refusal({item(1), item(1), item(2, kJump, 1, 1)}),
            "m: item 2: expected a jump to one item, found several with the number 1");
  EXPECT_EQ(refusal({item(1), item(2, kJump, 1, 5e8)}),
            "m: item 1: expected at most 1000000 items with all jumps taken, found more");
  EXPECT_EQ(refusal({item(1, kJump, 1, 5e8)}),
            "m: item 1: expected at most 1000000 items with all jumps taken, found more");
}

}  // namespace
}  // namespace traj
