#include "geom/map/difference.h"

#include <gtest/gtest.h>

#include "support/random_city.h"

namespace geom {
namespace {

BoxMap map_of(const BoxTable& table, double tile_size = 100) {
  BoxMapSpec spec;
  spec.bounds = {{-500, -500, 0}, {500, 500, 100}};
  spec.tile_size = tile_size;
  return {spec, table};
}

BoxTable table() {
  return support::table_of({{{0, 0, 0}, {10, 20, 30}}, {{40, 0, 0}, {50, 9, 7}}});
}

TEST(Difference, IsNoneWhateverTilesAndIds) {
  BoxTable other = table();
  other.ids = {8, 9};
  EXPECT_TRUE(difference(map_of(table()), map_of(other, 17)).none());
}

TEST(Difference, ListsWhatWasRemovedAndAdded) {
  BoxTable other = table();
  other.boxes[1].max.z() = 8;
  const MapDifference change = difference(map_of(table()), map_of(other));
  ASSERT_EQ(change.removed.size(), 1u);
  ASSERT_EQ(change.added.size(), 1u);
  EXPECT_FALSE(change.none());
  EXPECT_EQ(to_json_line("added", change.added[0]),
            "{\"type\":\"box\",\"change\":\"added\",\"id\":2,\"min\":[40,0,0],\"max\":[50,9,8],"
            "\"label\":\"\"}\n");
}

TEST(Difference, LooksAtLabelsTimesAndThePlace) {
  BoxTable other = table();
  other.label[0] = other.label_of("crane");
  other.set_time(1, {5, 6});
  BoxMapSpec timed = map_of(table()).spec();
  timed.epoch = "2026-05-04T06:00:00Z";
  EXPECT_EQ(difference(BoxMap(timed, table()), BoxMap(timed, other)).added.size(), 2u);
  BoxMapSpec spec = map_of(table()).spec();
  spec.bounds.max.z() = 99;
  spec.frame.axes = Axes::neu;
  spec.epoch = "2026-05-04T06:30:00Z";
  const MapDifference change = difference(map_of(table()), BoxMap(spec, table()));
  EXPECT_TRUE(change.added.empty());
  EXPECT_FALSE(change.same_bounds || change.same_frame || change.same_epoch);
}

}  // namespace
}  // namespace geom
