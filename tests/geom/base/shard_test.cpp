#include "geom/base/shard.h"

#include <gtest/gtest.h>

#include <limits>

namespace geom {
namespace {

TEST(Shard, GivesEachItemToOneShare) {
  for (const std::size_t count : {1u, 2u, 3u, 8u, 50u}) {
    for (const std::size_t items : {0u, 1u, 7u, 50u, 1000u}) {
      std::size_t next = 0;
      std::vector<int> taken(items);
      for (std::size_t k = 0; k < count; ++k) {
        const Shard shard{k, count};
        EXPECT_EQ(shard.begin(items), next);
        next = shard.end(items);
        EXPECT_LE(next - shard.begin(items), items / count + 1);
        for (const std::size_t i : shard.items(items)) {
          EXPECT_TRUE(shard.takes(i));
          ++taken[i];
        }
      }
      EXPECT_EQ(next, items);
      EXPECT_EQ(taken, std::vector<int>(items, 1));
    }
  }
}

TEST(Shard, DoesNotOverflow) {
  constexpr std::size_t kMost = std::numeric_limits<std::size_t>::max();
  EXPECT_EQ((Shard{999999, 1000000}.end(kMost)), kMost);
}

}  // namespace
}  // namespace geom
