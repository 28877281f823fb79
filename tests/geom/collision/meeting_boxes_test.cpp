#include "collision/meeting_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/random_city.h"

namespace geom {
namespace {

// However many there are, and however they come.
TEST(MeetingBoxes, GiveAllThatWereKeptAscending) {
  support::Random random(4);
  std::uint32_t next = 1;  // goes through all numbers of sixteen bits
  for (int i = 0; i < 400; ++i) {
    std::vector<std::size_t> kept;
    MeetingBoxes found;
    for (int batch = random.below(8); batch > 0; --batch) {
      const auto offered = static_cast<std::size_t>(random.below(i < 200 ? 6 : 80));
      std::size_t* const room = found.room(offered);
      std::size_t count = 0;
      for (std::size_t k = 0; k < offered; ++k) {
        room[count] = next = (next * 25173 + 13849) % 65536;
        if (random.below(3) > 0) kept.push_back(room[count++]);
      }
      found.keep(count);
      EXPECT_EQ(found.size(), kept.size());
    }
    std::sort(kept.begin(), kept.end());
    EXPECT_EQ(found.sorted(), kept) << i;
  }
}

}  // namespace
}  // namespace geom
