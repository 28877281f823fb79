#include "geom/map/map_patch.h"

#include <gtest/gtest.h>

#include "geom/map/derive.h"
#include "geom/map/join.h"
#include "support/reading.h"

namespace geom {
namespace {

// Boxes with the ids 3 and 5.
BoxMap two_boxes() {
  BoxTable table;
  table.add({{0, 0, 0}, {1, 1, 1}}, 3);
  table.add({{4, 4, 0}, {5, 5, 1}}, 5);
  return {{.bounds = {{0, 0, 0}, {9, 9, 9}}, .bounds_from = "option"}, table};
}

BoxTable one_box() {
  BoxTable table;
  table.add({{7, 7, 0}, {8, 8, 1}}, 0, table.label_of("crane"));
  return table;
}

TEST(ParseIds, TakesWholeNumbersBetweenCommasAndWhiteSpace) {
  EXPECT_EQ(parse_ids("1,2 3\r\n\t4,", "ids"), (std::set<std::uint64_t>{1, 2, 3, 4}));
  EXPECT_TRUE(parse_ids("", "ids").empty());
  EXPECT_EQ(support::refusal_of([] { parse_ids("1\nx", "ids"); }).find("ids:2: "), 0u);
  EXPECT_NE(support::refusal_of([] { parse_ids("-1", "ids"); }), "");
}

TEST(MapPatch, RemovesTheBoxesOfTheIds) {
  MapPatch patch(two_boxes(), "m");
  EXPECT_EQ(patch.remove({3}), 1u);
  const BoxMap made = patch.made();
  ASSERT_EQ(made.size(), 1u);
  EXPECT_EQ(made.ids()[0], 5u);
  EXPECT_TRUE(support::says(made.spec().history, R"("removed":1)"));
}

TEST(MapPatch, GivesNewBoxesIdsAboveAll) {
  MapPatch patch(two_boxes(), "m");
  EXPECT_EQ(patch.add("added", one_box()), 1u);
  EXPECT_EQ(patch.add("keep_out", one_box()), 1u);
  const BoxTable table = table_of(patch.made());
  EXPECT_EQ(std::set<std::uint64_t>(table.ids.begin(), table.ids.end()),
            (std::set<std::uint64_t>{3, 5, 6, 7}));
  EXPECT_TRUE(support::says(patch.made().spec().history, R"("added":1,"keep_out":1)"));
}

TEST(MapPatch, RefusesAnIdThatNoBoxHasAndAMapWithoutBoxes) {
  MapPatch patch(two_boxes(), "m");
  EXPECT_EQ(support::refusal_of([&] { patch.remove({4}); }).find("m: "), 0u);
  patch.remove({3, 5});
  EXPECT_EQ(support::refusal_of([&] { patch.made(); }).find("m: "), 0u);
}

// Each of the maps counts ids anew, so an id of the joined map may name two obstacles.
TEST(SharedIds, NamesBoxesOfAJoinedMapThatHaveOneId) {
  EXPECT_EQ(shared_ids(two_boxes(), {3, 5}), "");
  BoxTable table;
  table.add({{7, 7, 0}, {8, 8, 1}}, 5, table.label_of("mast"));
  const SourceMap maps[] = {
      {"a", two_boxes()},
      {"b", {{.bounds = {{0, 0, 0}, {9, 9, 9}}, .bounds_from = "option"}, table}}};
  const BoxMap joined = join(maps);
  EXPECT_EQ(shared_ids(joined, {3}), "");
  EXPECT_EQ(shared_ids(joined, {3, 5}),
            "the id 5 names 2 boxes of this joined map, which may be of different obstacles, as "
            "each map counts ids anew: (4, 4, 0) \"\", (7, 7, 0) \"mast\"");
}

TEST(MapPatch, KeepsTheEpochOfTheMap) {
  MapPatch patch(two_boxes(), "m");
  patch.set_epoch("2026-05-04T06:30:00Z");
  EXPECT_EQ(patch.made().spec().epoch, "2026-05-04T06:30:00Z");
  patch.set_epoch("2026-05-04T06:30:00Z");
  EXPECT_NE(support::refusal_of([&] { patch.set_epoch("2026-05-05T06:30:00Z"); }), "");
}

}  // namespace
}  // namespace geom
