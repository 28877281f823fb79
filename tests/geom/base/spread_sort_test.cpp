#include "base/spread_sort.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/random_city.h"

namespace geom {
namespace {

struct Item {
  double x;
  int rank;

  friend bool operator==(const Item&, const Item&) = default;
};

bool comes_before(const Item& a, const Item& b) { return a.x != b.x ? a.x < b.x : a.rank < b.rank; }

void expect_sorted(std::vector<Item> items) {
  std::vector<Item> expected = items;
  std::sort(expected.begin(), expected.end(), comes_before);
  spread_sort(items, comes_before);
  ASSERT_EQ(items, expected);
}

TEST(SpreadSort, SortsWhatIsEvenlySpreadOrNot) {
  support::Random random(8);
  for (int n : {0, 1, 2, 31, 32, 33, 1000}) {
    for (int kind = 0; kind < 5; ++kind) {
      std::vector<Item> items;
      for (int i = 0; i < n; ++i) {
        const double even = random.uniform(-50, 50);
        const double x = kind == 0   ? even
                         : kind == 1 ? std::floor(even)
                         : kind == 2 ? std::exp(even)
                         : kind == 3 ? 7
                                     : 1e8 + even * 1e-8;
        items.push_back({x, random.below(3)});
      }
      expect_sorted(items);
    }
  }
}

TEST(SpreadSort, SortsWhatIsTooNearToEachOtherForBins) {
  constexpr double kTiny = std::numeric_limits<double>::denorm_min();
  std::vector<Item> items;
  for (int i = 0; i < 100; ++i) items.push_back({i % 3 * kTiny, 100 - i});
  expect_sorted(items);
}

TEST(SpreadSort, TakesZerosOfBothSignsForOne) {
  std::vector<Item> items;
  for (int i = 0; i < 100; ++i) items.push_back({i % 2 ? 0.0 : -0.0, 100 - i});
  items.push_back({1, 0});
  spread_sort(items, comes_before);
  EXPECT_TRUE(std::is_sorted(items.begin(), items.end(), comes_before));
}

}  // namespace
}  // namespace geom
