#include "base/radix_sort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

namespace geom {
namespace {

std::vector<std::pair<std::uint64_t, std::uint64_t>> pairs(std::span<const Keyed> items) {
  std::vector<std::pair<std::uint64_t, std::uint64_t>> out;
  for (const Keyed& item : items) out.emplace_back(item.key, item.item);
  return out;
}

TEST(RadixSort, IsAStableSortByKeyForAnyNumberOfThreads) {
  std::mt19937_64 random(3);
  for (const std::uint64_t largest : {0ull, 1ull, 700ull, 2047ull, 2048ull, 1ull << 40, ~0ull}) {
    for (const std::size_t n : {0, 1, 5000, 150000}) {
      LargeArray<Keyed> items(n);
      for (std::size_t i = 0; i < n; ++i) {
        const std::uint64_t drawn = random();
        items.all()[i] = {largest == ~0ull ? drawn : drawn % (largest + 1), i};
      }
      std::vector<Keyed> expected(items.all().begin(), items.all().end());
      std::stable_sort(expected.begin(), expected.end(),
                       [](const Keyed& a, const Keyed& b) { return a.key < b.key; });
      for (const unsigned threads : {1u, 2u, 7u}) {
        LargeArray<Keyed> copy(n);
        std::copy(items.all().begin(), items.all().end(), copy.all().begin());
        const auto sorted = radix_sorted(std::move(copy), largest, {threads, {}});
        ASSERT_EQ(pairs(sorted.all()), pairs(expected)) << largest << ", " << n << ", " << threads;
      }
    }
  }
}

}  // namespace
}  // namespace geom
