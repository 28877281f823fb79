#include "base/radix_sort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <utility>
#include <vector>

namespace geom {
namespace {

template <class Number>
std::vector<std::pair<Number, Number>> pairs(std::span<const Keyed<Number>> items) {
  std::vector<std::pair<Number, Number>> out;
  for (const Keyed<Number>& item : items) out.emplace_back(item.key, item.item);
  return out;
}

// Keys from 0 to `largest`, or of any bits where that is all of them.
template <class Number>
void expect_stable_sort(std::uint64_t largest, std::size_t n, std::mt19937_64& random) {
  LargeArray<Keyed<Number>> items(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint64_t drawn = random();
    items.all()[i] = {static_cast<Number>(~largest ? drawn % (largest + 1) : drawn),
                      static_cast<Number>(i)};
  }
  std::vector<Keyed<Number>> expected(items.all().begin(), items.all().end());
  std::stable_sort(expected.begin(), expected.end(),
                   [](const auto& a, const auto& b) { return a.key < b.key; });
  for (const unsigned threads : {1u, 2u, 7u}) {
    LargeArray<Keyed<Number>> copy(n);
    std::copy(items.all().begin(), items.all().end(), copy.all().begin());
    const auto sorted = radix_sorted(std::move(copy), largest, {threads, {}});
    ASSERT_EQ(pairs<Number>(sorted.all()), pairs<Number>(expected))
        << largest << ", " << n << ", " << threads;
  }
}

TEST(RadixSort, IsAStableSortByKeyForAnyNumberOfThreads) {
  std::mt19937_64 random(3);
  for (const std::size_t n : {0, 1, 5000, 150000}) {
    for (const std::uint64_t largest : {0ull, 1ull, 700ull, 2047ull, 2048ull, 1ull << 40, ~0ull}) {
      expect_stable_sort<std::uint64_t>(largest, n, random);
    }
    for (const std::uint64_t largest : {0ull, 700ull, 2048ull, (1ull << 32) - 1}) {
      expect_stable_sort<std::uint32_t>(largest, n, random);
    }
  }
}

}  // namespace
}  // namespace geom
