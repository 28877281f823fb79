#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "geom/import/import_boxes.h"
#include "support/reading.h"

namespace geom {
namespace {

ImportedBoxes read(const std::string& text) {
  return import_boxes(support::Text(text), kRotorPyWorld, "w.json");
}

TEST(WorldJson, KeysThatMayTurnOrAddBlocksAreSkipped) {
  const auto world = [](const std::string& more, const std::string& in_block) {
    return R"({"bounds":{"extents":[0,9,0,9,0,9]},"blocks":[{"extents":[1,2,1,2,1,2])" + in_block +
           "}]" + more + "}";
  };
  EXPECT_EQ(read(world("", "")).skipped.count(), 0u);
  EXPECT_EQ(read(world(",\"start\":[1,1,1]", ",\"colour\":1")).skipped.count(), 0u);
  EXPECT_EQ(read(world(",\"spheres\":[]", "")).skipped.count(), 1u);
  EXPECT_EQ(read(world("", ",\"rotation\":45")).skipped.count(), 1u);
}

TEST(WorldJson, ReadsBoundsBlocksAndColours) {
  const ImportedBoxes world =
      read(R"({"bounds":{"extents":[-1,9,-2,8,0,7]},"start":[1,1,1],"author":"x","name":"w",)"
           R"("blocks":[{"extents":[1,2,3,4,5,6],"color":[1,0.5,0]},{"extents":[1,1,3,4,5,6]}]})");
  EXPECT_EQ(world.bounds, (Aabb{{-1, -2, 0}, {9, 8, 7}}));
  ASSERT_EQ(world.table.boxes.size(), 2u);
  EXPECT_EQ(world.table.boxes[0], (Aabb{{1, 3, 5}, {2, 4, 6}}));
  EXPECT_EQ(world.table.labels[world.table.label[0]], "1 0.5 0");
  EXPECT_EQ(world.table.labels[world.table.label[1]], "");
  EXPECT_EQ(world.table.ids, (std::vector<std::uint64_t>{0, 1}));
  EXPECT_EQ(world.flat, 1u);
  EXPECT_EQ(world.names, std::vector<std::string>{"name"});
  EXPECT_EQ(world.skipped.count(), 1u) << "author may mean an obstacle";
}

TEST(WorldJson, TakesExtentsInEitherOrder) {
  const ImportedBoxes world =
      read(R"({"bounds":{"extents":[9,0,0,9,0,9]},"blocks":[{"extents":[2,1,1,2,6,5]}]})");
  EXPECT_EQ(world.bounds, (Aabb{{0, 0, 0}, {9, 9, 9}}));
  EXPECT_EQ(world.table.boxes[0], (Aabb{{1, 1, 5}, {2, 2, 6}}));
  EXPECT_EQ(world.reversed, 2u);
}

TEST(WorldJson, RefusesWhatIsNoWorld) {
  const auto world = [](const std::string& extents) {
    return R"({"bounds":{"extents":[0,9,0,9,0,9]},"blocks":[{"extents":)" + extents + "}]}";
  };
  EXPECT_NO_THROW(read(world("[1,2,1,2,1,2]")));
  for (const std::string& bad :
       {std::string(), std::string("[]"), std::string("{}"),
        std::string(R"({"blocks":[{"extents":[1,2,1,2,1,2]}]})"),
        std::string(R"({"bounds":{"extents":[0,9,0,9,0,9]},"blocks":[]})"), world("[1,2,1,2,1]"),
        world("[1,2,1,2,1,\"2\"]"), world("[1,1,1,1,1,1]"), world("[1,2,1,2,1,1e9]")}) {
    EXPECT_THROW(read(bad), InputError) << bad;
  }
}

}  // namespace
}  // namespace geom
