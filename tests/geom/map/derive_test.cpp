#include "geom/map/derive.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "geom/base/error.h"
#include "geom/map/map_doubts.h"
#include "geom/map/map_draft.h"
#include "support/random_city.h"

namespace geom {
namespace {

using Json = nlohmann::json;

BoxMap city(const std::string& history = "") {
  BoxMapSpec spec;
  spec.bounds = {{0, 0, 0}, {100, 100, 50}};
  spec.history = history;
  return {spec, support::table_of({{{0, 0, 0}, {10, 20, 30}}, {{60, 60, 0}, {80, 70, 20}}})};
}

TEST(Derived, KeepsTheHistoryAndAddsAStep) {
  const BoxMap tiled = tile(city(R"([{"tool":"skyway-import"}])"), 25);
  const Json history = Json::parse(tiled.spec().history);
  ASSERT_EQ(history.size(), 2u);
  EXPECT_EQ(history[0]["tool"], "skyway-import");
  EXPECT_EQ(history[1]["tool"], "skyway-map tile");
  EXPECT_EQ(history[1]["input"], city().hash());
  EXPECT_EQ(tiled.hash(), city().hash());
  EXPECT_EQ(tiled.spec().tile_size, 25);
}

TEST(Crop, KeepsWhatMeetsTheRegion) {
  const BoxMap part = crop(city(), {{-5, -5, 0}, {60, 40, 200}}, "city");
  EXPECT_EQ(part.size(), 1u);
  EXPECT_EQ(part.spec().bounds, (Aabb{{0, 0, 0}, {60, 40, 50}}));
  EXPECT_THROW(crop(city(), {{200, 0, 0}, {300, 9, 9}}, "city"), InputError);
}

TEST(WithBounds, KeepsAllBoxesAndSetsWhatIsSaid) {
  const MadeMap made = with_bounds(city(), {.floor = -2, .ceiling = 90}, "city");
  EXPECT_EQ(made.map.size(), 2u);
  EXPECT_EQ(made.map.spec().bounds, (Aabb{{0, 0, -2}, {100, 100, 90}}));
  EXPECT_EQ(made.map.spec().bounds_from, "option");
  EXPECT_EQ(made.beyond, 0u);
  const Json step = Json::parse(made.map.spec().history).back();
  EXPECT_EQ(step["tool"], "skyway-map bounds");
  EXPECT_EQ(step["ceiling"], 90);
  EXPECT_EQ(step["floor"], -2);
  const Aabb box{{-1, -1, 0}, {50, 50, 40}};
  EXPECT_EQ(with_bounds(city(), {.bounds = box}, "city").map.spec().bounds, box);
}

TEST(WithBounds, PadReachesBeyondTheObstaclesAndNeverMakesBoundsSmaller) {
  EXPECT_EQ(with_bounds(city(), {.pad = 30}, "city").map.spec().bounds,
            (Aabb{{-30, -30, 0}, {110, 100, 60}}));
  EXPECT_EQ(with_bounds(city(), {.pad = 0}, "city").map.spec().bounds, city().spec().bounds);
}

TEST(WithBounds, CountsWhatIsBeyondAndRefusesEmptyBounds) {
  EXPECT_EQ(with_bounds(city(), {.bounds = Aabb{{0, 0, 0}, {50, 50, 40}}}, "city").beyond, 1u);
  EXPECT_THROW(with_bounds(city(), {.ceiling = 0}, "city"), InputError);
}

TEST(WithBounds, HasNothingToPadInAMapWithoutBoxes) {
  const BoxMap none = crop(city(), {{40, 40, 30}, {45, 45, 40}}, "city");
  ASSERT_EQ(none.size(), 0u);
  EXPECT_THROW(with_bounds(none, {.pad = 5}, "city"), InputError);
  EXPECT_NO_THROW(with_bounds(none, {.ceiling = 60}, "city"));
}

TEST(Derived, RefusesBoxesThatNoReaderTakes) {
  EXPECT_NO_THROW(inflate(city(), 9e7));
  EXPECT_THROW(inflate(city(), 1e8), InputError);
}

TEST(Inflate, GrowsEachBoxOnEverySide) {
  const BoxMap grown = inflate(city(), 0.5);
  EXPECT_EQ(grown.size(), 2u);
  for (const Aabb& box : grown.boxes()) EXPECT_LE(box.min.z(), -0.5);
}

TEST(Join, HasTheBoxesAndTheBoundsOfAll) {
  BoxMapSpec spec = city().spec();
  spec.bounds = {{90, 0, -10}, {200, 50, 40}};
  spec.history = R"([{"skipped":3}])";
  const BoxMap other(spec, support::table_of({{{150, 0, 0}, {160, 9, 9}}}));
  const SourceMap maps[] = {{"a", city()}, {"b", other}};
  const BoxMap joined = join(maps);
  EXPECT_EQ(joined.size(), 3u);
  EXPECT_EQ(joined.spec().bounds, (Aabb{{0, 0, -10}, {200, 100, 50}}));
  EXPECT_EQ(skipped_in(joined.spec()), 3u);
}

TEST(Join, SaysHowMuchOfItsBoundsNoMapKnows) {
  const auto with = [](const Aabb& bounds) {
    BoxMapSpec spec = city().spec();
    spec.bounds = bounds;
    return SourceMap{"map", BoxMap(spec, support::table_of({{{0, 0, 0}, {1, 1, 1}}}))};
  };
  const SourceMap west = with({{0, 0, 0}, {10, 10, 10}});
  const SourceMap east = with({{10, 0, 0}, {20, 10, 10}});
  const SourceMap low = with({{10, 0, 0}, {20, 10, 5}});
  const SourceMap far = with({{30, 0, 0}, {40, 10, 10}});
  const auto gap = [](std::vector<SourceMap> maps) { return doubts_of(join(maps).spec()).gap; };
  EXPECT_EQ(gap({west, east}), 0);
  EXPECT_NEAR(gap({west, low}), 0.25, 1e-3) << "above the second";
  EXPECT_NEAR(gap({west, far}), 0.5, 1e-3) << "between them";
  EXPECT_EQ(gap({west, far, east, with({{20, 0, 0}, {30, 10, 10}})}), 0);
  EXPECT_NEAR(gap({west, {"joined", join(std::vector{west, far})}}), 0.5, 1e-3)
      << "of a join before";
}

TEST(Join, RefusesTwoEpochs) {
  BoxMapSpec spec = city().spec();
  spec.epoch = "2026-05-04T06:30:00Z";
  const BoxTable table = support::table_of({{{0, 0, 0}, {1, 1, 1}}});
  const BoxMap one(spec, table);
  spec.epoch = "2027-05-04T06:30:00Z";
  const BoxMap other(spec, table);
  const SourceMap maps[] = {{"a", city()}, {"b", one}, {"c", other}};
  EXPECT_THROW(join(maps), InputError);
  EXPECT_EQ(join(std::span(maps).first(2)).spec().epoch, one.spec().epoch);
}

}  // namespace
}  // namespace geom
