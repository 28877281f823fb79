#include "geom/cloud/las_class.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace geom {
namespace {

std::vector<int> numbers(std::string_view name) {
  const auto found = las_classes(name);
  return {found.begin(), found.end()};
}

TEST(LasClass, IsKnownByName) {
  EXPECT_EQ(numbers("ground"), (std::vector<int>{2}));
  EXPECT_EQ(numbers("building"), (std::vector<int>{6}));
  EXPECT_EQ(numbers("vegetation"), (std::vector<int>{3, 4, 5}));
  EXPECT_EQ(numbers("noise"), (std::vector<int>{7, 18}));
  EXPECT_TRUE(numbers("Building").empty());
  EXPECT_TRUE(numbers("").empty());
}

TEST(LasClass, EveryNameOfTheListIsKnownAndNoClassHasTwoOfItsOwn) {
  std::string list(las_class_names());
  std::multiset<int> alone;
  for (std::size_t at = 0; at < list.size();) {
    const std::size_t end = std::min(list.find(", ", at), list.size());
    const auto found = numbers(list.substr(at, end - at));
    ASSERT_FALSE(found.empty()) << list.substr(at, end - at);
    if (found.size() == 1) alone.insert(found.front());
    at = end + 2;
  }
  for (const int cls : alone) EXPECT_EQ(alone.count(cls), 1u) << cls;
}

TEST(LasClass, NoiseIsWhatIsNamedSo) {
  for (int cls = 0; cls < 256; ++cls) {
    EXPECT_EQ(is_noise_class(static_cast<std::uint8_t>(cls)), cls == 7 || cls == 18);
  }
}

}  // namespace
}  // namespace geom
