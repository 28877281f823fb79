#include "geom/map/description.h"

#include <gtest/gtest.h>

#include "support/random_city.h"

namespace geom {
namespace {

BoxMap map_with_two_boxes() {
  BoxMapSpec spec;
  spec.bounds = {{0, 0, 0}, {40, 30, 20}};
  spec.bounds_from = "option";
  spec.frame.axes = Axes::neu;
  spec.frame.origin = GeodeticOrigin{60.17, 24.94, 3};
  spec.epoch = "2026-05-04T06:30:00Z";
  spec.history = R"([{"op":"import","unknown":"free"}])";
  BoxTable table = support::table_of({{{1, 1, 0}, {4, 4, 10}}, {{2, 2, 0}, {3, 3, 4}}});
  table.set_time(1, {0, 60});
  return BoxMap(spec, table);
}

TEST(Description, SaysWhatTheFileHolds) {
  const auto json = description(map_with_two_boxes());
  EXPECT_EQ(json["boxes"], 2);
  EXPECT_EQ(json["frame"], "neu");
  EXPECT_EQ(json["bounds_max_m"], nlohmann::json({40.0, 30.0, 20.0}));
  EXPECT_EQ(json["bounds_from"], "option");
  EXPECT_EQ(json["origin"]["longitude_deg"], 24.94);
  EXPECT_EQ(json["epoch"], "2026-05-04T06:30:00Z");
  EXPECT_EQ(json["timed_boxes"], 1);
  EXPECT_EQ(json["history"][0]["op"], "import");
  EXPECT_FALSE(json.contains("heights_m"));
}

TEST(Description, LeavesOutWhatTheMapDoesNotHave) {
  const auto json = description(support::random_city(1, 5, 50));
  for (const char* key : {"origin", "crs", "epoch", "timed_boxes", "skipped_obstacles"}) {
    EXPECT_FALSE(json.contains(key)) << key;
  }
}

TEST(FullDescription, CountsOverlapsOnlyIfAsked) {
  const BoxMap map = map_with_two_boxes();
  const auto json = full_description(map, true);
  EXPECT_EQ(json["overlapping_pairs"], 1);
  EXPECT_EQ(json["contained"], 1);
  EXPECT_EQ(json["heights_m"]["max"], 10.0);
  EXPECT_EQ(json["unknown"], nlohmann::json({"free"}));
  EXPECT_EQ(std::prev(json.end()).key(), "history");
  EXPECT_FALSE(full_description(map, false).contains("overlapping_pairs"));
}

TEST(AsLines, EscapesWhatCannotBePrinted) {
  EXPECT_EQ(as_lines({{"name", "a\x1b[2J"}, {"boxes", 2}}).find('\x1b'), std::string::npos);
  EXPECT_EQ(as_lines({{"name", "city"}, {"boxes", 2}}), "name: city\nboxes: 2\n");
}

}  // namespace
}  // namespace geom
