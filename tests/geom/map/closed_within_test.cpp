#include "geom/map/closed_within.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "geom/map/derive.h"
#include "geom/map/map_patch.h"
#include "support/random_city.h"

namespace geom {
namespace {

BoxMap plain(double side) {
  BoxTable table;
  table.add({{1, 1, 0}, {2, 2, 5}}, 0);
  return {{.frame = {}, .bounds = {{0, 0, 0}, {side, side, 50}}, .bounds_from = "source"}, table};
}

BoxMap with_zones(const BoxMap& map) {
  MapPatch patch(map, "city.boxmap");
  patch.note_cut_to_bounds();
  return patch.made();
}

TEST(ClosedWithin, AreTheBoundsThatTheZonesWereCutTo) {
  EXPECT_FALSE(closed_within(plain(100).spec()));
  const auto within = closed_within(with_zones(plain(100)).spec());
  ASSERT_TRUE(within);
  EXPECT_EQ(*within, (Aabb{{0, 0, 0}, {100, 100, 50}}));
}

TEST(ClosedWithin, RefusesWiderBoundsOfAMapWithZones) {
  const BoxMap map = with_zones(plain(100));
  EXPECT_THROW(with_bounds(map, {.ceiling = 60}, "city.boxmap"), InputError);
  EXPECT_THROW(with_bounds(map, {.pad = 200}, "city.boxmap"), InputError);
  EXPECT_NO_THROW(with_bounds(map, {.ceiling = 40}, "city.boxmap"));
  EXPECT_NO_THROW(with_bounds(plain(100), {.ceiling = 60}, "city.boxmap"));
}

TEST(ClosedWithin, CountsTheHeightsThatAVolumeWithoutAltitudesReachesTo) {
  const BoxMap map = plain(100);
  MapPatch patch(map, "city.boxmap");
  patch.note_cut_to_heights(false, true);
  const BoxMap open = patch.made();
  EXPECT_THROW(with_bounds(open, {.ceiling = 60}, "city.boxmap"), InputError);
  EXPECT_NO_THROW(with_bounds(open, {.bounds = Aabb{{-90, -90, -10}, {900, 900, 50}}}, "c"));
  patch.note_cut_to_heights(true, false);
  EXPECT_THROW(with_bounds(patch.made(), {.ceiling = 60}, "c"), InputError) << "both count";
  EXPECT_THROW(with_bounds(patch.made(), {.floor = -10}, "c"), InputError);
  MapPatch none(map, "city.boxmap");
  none.note_cut_to_heights(false, false);
  EXPECT_FALSE(closed_within(none.made().spec()));
}

TEST(ClosedWithin, IsCutByACrop) {
  const BoxMap cropped = crop(with_zones(plain(100)), {{0, 0, 0}, {40, 40, 50}}, "city.boxmap");
  EXPECT_THROW(with_bounds(cropped, {.bounds = Aabb{{0, 0, 0}, {50, 50, 50}}}, "c"), InputError);
}

TEST(ClosedWithin, RefusesAJoinThatWidensTheBounds) {
  const BoxMap small = with_zones(plain(100));
  const std::vector<SourceMap> wider = {{"a", small}, {"b", plain(200)}};
  EXPECT_THROW(join(wider), InputError);
  const std::vector<SourceMap> turned = {{"b", plain(200)}, {"a", small}};
  EXPECT_THROW(join(turned), InputError);
  const std::vector<SourceMap> inner = {{"a", small}, {"b", plain(50)}};
  const BoxMap joined = join(inner);
  EXPECT_THROW(with_bounds(joined, {.ceiling = 60}, "c"), InputError);
}

}  // namespace
}  // namespace geom
