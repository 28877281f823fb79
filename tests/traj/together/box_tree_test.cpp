#include "together/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "support/random_city.h"

namespace traj {
namespace {

std::vector<TimedBox> random_boxes(std::uint64_t seed, int count) {
  support::Random random(seed);
  std::vector<TimedBox> boxes(static_cast<std::size_t>(count));
  for (TimedBox& box : boxes) {
    for (std::size_t i = 0; i < 4; ++i) {
      box.low[i] = random.stepped(0, 40, 1);
      box.high[i] = box.low[i] + random.stepped(0, 8, 1);
    }
    const int parked = random.below(8);
    if (parked == 0) box.low[3] = -std::numeric_limits<double>::infinity();
    if (parked == 1) box.high[3] = std::numeric_limits<double>::infinity();
    box.flight = static_cast<std::uint32_t>(random.below(60));
  }
  return boxes;
}

TEST(BoxTree, FindsWhatEachAgainstEachFinds) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const auto boxes = random_boxes(seed, seed < 5 ? static_cast<int>(seed) : 700);
    std::set<FlightPair> expected;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        if (boxes[i].flight == boxes[k].flight || !meet(boxes[i], boxes[k])) continue;
        expected.insert(std::minmax(boxes[i].flight, boxes[k].flight));
      }
    }
    const auto found = meeting_flights(boxes, {});
    EXPECT_TRUE(std::equal(found.begin(), found.end(), expected.begin(), expected.end())) << seed;
    EXPECT_EQ(meeting_flights(boxes, {3, {}}), found);
  }
}

TEST(BoxTree, CountsTouchingAsMeeting) {
  TimedBox a;
  TimedBox b;
  a.high = {1, 1, 1, 1};
  b.low = {1, 0, 0, 1};
  b.high = {2, 1, 1, 2};
  EXPECT_TRUE(meet(a, b));
  b.low[3] = std::nextafter(1.0, 2.0);
  EXPECT_FALSE(meet(a, b));
}

}  // namespace
}  // namespace traj
