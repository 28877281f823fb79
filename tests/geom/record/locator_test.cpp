#include "geom/record/locator.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "support/random_city.h"
#include "support/reading.h"

namespace geom {
namespace {

BoxMap map_at(const std::optional<GeodeticOrigin>& origin, Axes axes = Axes::enu,
              const std::string& history = "") {
  BoxMapSpec spec;
  spec.history = history;
  spec.bounds = {{-100, -100, -3}, {100, 100, 50}};
  spec.frame.origin = origin;
  spec.frame.axes = axes;
  return BoxMap(spec,
                support::table_of({{{10, 20, 0}, {20, 40, 12}}, {{10, 20, 0}, {12, 22, 30}}}));
}

TEST(Locator, LeavesMetresAlone) {
  const BoxMap map = map_at({});
  EXPECT_EQ(Locator(map).at(Vec3(1, 2, 3), "q", 0), Vec3(1, 2, 3));
}

TEST(Locator, PutsPlacesOnEarthIntoTheAxesOfTheMap) {
  const GeodeticOrigin origin{60, 25, 10};
  const GeodeticPlace there = GeographicFrame(origin).place({30, 40, 0});
  const EarthPlace place{there.latitude, there.longitude, 7, false};
  const BoxMap enu = map_at(origin);
  const BoxMap neu = map_at(origin, Axes::neu);
  EXPECT_NEAR((Locator(enu).at(place, "q", 0) - Vec3(30, 40, 7)).norm(), 0, 1e-6);
  EXPECT_NEAR((Locator(neu).at(place, "q", 0) - Vec3(40, 30, 7)).norm(), 0, 1e-6);
}

TEST(Locator, CountsFromTheHighestBoxUnderThePlaceOrFromTheFloor) {
  const GeodeticOrigin origin{60, 25, 0};
  const BoxMap map = map_at(origin);
  const Locator locator(map);
  const auto height_at = [&](double x, double y) {
    const GeodeticPlace p = GeographicFrame(origin).place({x, y, 0});
    return locator.at(EarthPlace{p.latitude, p.longitude, 2, true}, "q", 0).z();
  };
  EXPECT_EQ(height_at(15, 30), 14);
  EXPECT_EQ(height_at(11, 21), 32);
  EXPECT_EQ(height_at(50, 50), -1);
}

TEST(Locator, RefusesToCountFromAHoleInAScan) {
  const GeodeticOrigin origin{60, 25, 0};
  const GeodeticPlace p = GeographicFrame(origin).place({50, 50, 0});
  for (const char* history :
       {R"([{"tool":"skyway-cloud"}])", R"([{"tool":"skyway-footprints","format":"raster"}])",
        R"([{"tool":"skyway-map join","histories":[[{"tool":"skyway-cloud"}]]}])"}) {
    const BoxMap map = map_at(origin, Axes::enu, history);
    const Locator locator(map);
    EXPECT_TRUE(support::says(support::refusal_of([&] {
                                locator.at(EarthPlace{p.latitude, p.longitude, 2, true}, "q", 3);
                              }),
                              "q:3: nothing was scanned under latitude"));
    EXPECT_EQ(locator.at(EarthPlace{p.latitude, p.longitude, 2, false}, "q", 3).z(), 2);
    const GeodeticPlace roof = GeographicFrame(origin).place({15, 30, 0});
    EXPECT_EQ(locator.at(EarthPlace{roof.latitude, roof.longitude, 2, true}, "q", 3).z(), 14);
  }
  const BoxMap odd = map_at(origin, Axes::enu, R"([{"tool":7,"format":["raster"]}])");
  EXPECT_EQ(Locator(odd).at(EarthPlace{p.latitude, p.longitude, 2, true}, "q", 3).z(), -1);
}

TEST(Locator, RefusesWhatHasNoPlaceOnTheMap) {
  const EarthPlace place{60, 25, 0, false};
  const BoxMap nowhere = map_at({});
  EXPECT_TRUE(support::says(support::refusal_of([&] { Locator(nowhere).at(place, "q.jsonl", 3); }),
                            "q.jsonl:3: a place in degrees has no place on a map"));
  const BoxMap far = map_at(GeodeticOrigin{40, 25, 0});
  EXPECT_TRUE(
      support::says(support::refusal_of([&] { Locator(far).at(place, "q.jsonl", 3); }), "1000 km"));
  const BoxMap other_side = map_at(GeodeticOrigin{0, -155, 0});
  EXPECT_THROW(Locator(other_side).at(place, "q", 0), InputError);
}

}  // namespace
}  // namespace geom
