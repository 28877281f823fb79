#include "collision/huge_arena.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <map>
#include <new>
#include <thread>
#include <vector>

namespace geom {
namespace {

TEST(HugeArena, GivesAlignedPiecesThatDoNotOverlap) {
  HugeArena arena;
  std::map<std::byte*, std::size_t> taken;
  for (std::size_t i = 0; i < 3000; ++i) {
    const std::size_t bytes = 1 + i * 37 % 20000;
    auto* const at = static_cast<std::byte*>(arena.take(bytes));
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(at) % HugeArena::kAlign, 0u);
    std::memset(at, static_cast<int>(i % 251), bytes);
    taken[at] = bytes;
  }
  const std::byte* last = nullptr;
  for (const auto& [at, bytes] : taken) {
    EXPECT_GE(at, last);
    last = at + bytes;
    EXPECT_EQ(at[0], at[bytes - 1]);
  }
}

TEST(HugeArena, GivesMoreThanAChunkHolds) {
  HugeArena arena;
  for (const std::size_t bytes : {std::size_t{1}, std::size_t{100} << 20, std::size_t{70}}) {
    auto* const at = static_cast<std::byte*>(arena.take(bytes));
    at[0] = std::byte{1};
    at[bytes - 1] = std::byte{2};
  }
}

TEST(HugeArena, MayBeAskedByThreadsAtOnce) {
  HugeArena arena;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&, t] {
      std::vector<std::byte*> mine;
      for (int i = 0; i < 500; ++i) {
        mine.push_back(static_cast<std::byte*>(arena.take(3000)));
        std::memset(mine.back(), t, 3000);
      }
      for (const std::byte* at : mine) {
        for (int k = 0; k < 3000; ++k) ASSERT_EQ(at[k], static_cast<std::byte>(t));
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
}

// And can be asked again.
TEST(HugeArena, ThrowsWhereThereIsNoMemory) {
  HugeArena arena;
  EXPECT_THROW(arena.take(std::size_t{1} << 60), std::bad_alloc);
  EXPECT_NE(arena.take(1000), nullptr);
}

}  // namespace
}  // namespace geom
