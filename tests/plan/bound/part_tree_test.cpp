#include "bound/part_tree.h"

#include <gtest/gtest.h>

#include "bound/line_label.h"
#include "support/random_city.h"

namespace plan {
namespace {

TEST(PartTree, FindsWhatAShortPathReachesInOrder) {
  support::Random random(4);
  std::vector<EdgePart> parts;
  for (int i = 0; i < 500; ++i) {
    EdgePart part;
    for (int k = 0; k < 3; ++k) part.low[k] = random.uniform(0, 100);
    part.high = part.low;
    part.axis = static_cast<std::uint8_t>(random.below(3));
    part.high[part.axis] += random.uniform(0, 10);
    parts.push_back(part);
  }
  const PartTree tree(parts);
  std::size_t found = 0;
  for (int n = 0; n < 50; ++n) {
    const EdgePart from{Vec3::Constant(random.uniform(0, 100)), {}, kCorner, {}};
    const EdgePart to{Vec3::Constant(random.uniform(0, 100)), {}, kCorner, {}};
    const auto ends = [](EdgePart end) { return EdgePart{end.low, end.low, kCorner, {}}; };
    const double length = (to.low - from.low).norm() + random.uniform(0, 40);
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < parts.size(); ++i) {
      if (least_distance(ends(from), parts[i]) + least_distance(parts[i], ends(to)) < length) {
        expected.push_back(i);
      }
    }
    EXPECT_EQ(tree.within(from.low, to.low, length), expected);
    found += expected.size();
  }
  EXPECT_GT(found, 500u);
  EXPECT_EQ(tree.parts().size(), parts.size());
}

TEST(PartTree, OfNothingFindsNothing) {
  EXPECT_TRUE(PartTree().within({0, 0, 0}, {1, 1, 1}, 10).empty());
  EXPECT_TRUE(PartTree(std::vector<EdgePart>{}).within({0, 0, 0}, {1, 1, 1}, 10).empty());
}

}  // namespace
}  // namespace plan
