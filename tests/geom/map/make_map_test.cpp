#include "geom/map/make_map.h"

#include <gtest/gtest.h>

#include <limits>

#include "geom/base/error.h"
#include "support/random_city.h"
#include "support/reading.h"

namespace geom {
namespace {

MadeMap made(std::vector<Aabb> boxes, const MakeMapOptions& options, const Frame& frame = {}) {
  return make_map(support::table_of(std::move(boxes)), frame, "[]", "t.csv", options);
}

const Aabb kHouse{{0, 0, 2}, {10, 20, 30}};

TEST(MakeMap, BoundsAreThoseOfTheObstaclesPaddedSidewaysAndUpward) {
  const BoxMap map = made({kHouse, {{30, 0, 5}, {40, 5, 9}}}, {.pad = 3}).map;
  EXPECT_EQ(map.spec().bounds, (Aabb{{-3, -3, 2}, {43, 23, 33}}));
  EXPECT_EQ(map.spec().bounds_from, "obstacles");
  EXPECT_EQ(made({kHouse}, {.floor = -1, .ceiling = 99}).map.spec().bounds,
            (Aabb{{0, 0, -1}, {10, 20, 99}}));
}

TEST(MakeMap, HeadroomStandsInPlaceOfThePadUpward) {
  EXPECT_EQ(made({kHouse}, {.pad = 3, .headroom = 100}).map.spec().bounds,
            (Aabb{{-3, -3, 2}, {13, 23, 130}}));
  EXPECT_EQ(made({kHouse}, {.ceiling = 50, .headroom = 100}).map.spec().bounds.max.z(), 50);
}

TEST(MakeMap, BoundsAskedForReplaceThoseOfTheSourceWhichAreScaled) {
  MakeMapOptions options{.scale = 2, .source_bounds = Aabb{{0, 0, 0}, {50, 50, 50}}, .pad = 3};
  EXPECT_EQ(made({kHouse}, options).map.spec().bounds, (Aabb{{0, 0, 0}, {100, 100, 100}}));
  EXPECT_EQ(made({kHouse}, options).map.spec().bounds_from, "source");
  options.floor = 1;
  EXPECT_EQ(made({kHouse}, options).map.spec().bounds.min.z(), 1);
  options.bounds = Aabb{{-5, -5, -5}, {70, 70, 70}};
  EXPECT_EQ(made({kHouse}, options).map.spec().bounds, *options.bounds);
  EXPECT_EQ(made({kHouse}, options).map.spec().bounds_from, "option");
}

TEST(MakeMap, ScalesThenBloatsThenInflates) {
  const Aabb box = made({{{0, 0, 0}, {1, 2, 4}}}, {.scale = 10, .bloat_percent = 50, .inflate = 1})
                       .map.boxes()[0];
  EXPECT_LT((box.min - Vec3(-3.5, -6, -11)).norm(), 1e-8);
  EXPECT_LT((box.max - Vec3(13.5, 26, 51)).norm(), 1e-8);
}

TEST(MakeMap, GrowthLosesNothingToRounding) {
  support::Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 low(random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9));
    const Aabb box{low, low + Vec3::Constant(random.uniform(0.1, 5))};
    const double scale = random.uniform(0.01, 40);
    const Aabb grown = made({box}, {.scale = scale}).map.boxes()[0];
    for (int k = 0; k < 3; ++k) {
      const auto exact = [&](double v) { return static_cast<long double>(v) * scale; };
      ASSERT_LE(static_cast<long double>(grown.min[k]), exact(box.min[k])) << "seed 1, case " << i;
      ASSERT_GE(static_cast<long double>(grown.max[k]), exact(box.max[k])) << "seed 1, case " << i;
      ASSERT_NEAR(grown.max[k], box.max[k] * scale, 1e-12) << "seed 1, case " << i;
    }
  }
}

TEST(MakeMap, LetsDownWhatHangsLessThanTheSealAboveTheFloor) {
  const MadeMap sealed =
      made({kHouse, {{30, 0, 5}, {40, 5, 9}}, {{50, 0, 0}, {60, 5, 9}}}, {.floor = 0, .seal = 5});
  EXPECT_EQ(sealed.sealed, 1u);
  EXPECT_EQ(sealed.map.boxes()[0].min.z(), 0) << "hung at 2 m";
  EXPECT_EQ(sealed.map.boxes()[1].min.z(), 5) << "hangs at 5 m: not less";
}

TEST(MakeMap, CountsWhatIsWhollyBeyondTheBoundsAndKeepsIt) {
  const MadeMap map = made({kHouse, {{30, 0, 5}, {40, 5, 9}}, {{10, 0, 0}, {20, 5, 9}}},
                           {.bounds = Aabb{{0, 0, 0}, {10, 10, 10}}});
  EXPECT_EQ(map.beyond, 1u) << "what touches is not beyond";
  EXPECT_EQ(map.map.size(), 3u);
}

TEST(MakeMap, RefusesBoundsAndNumbersThatAreNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(made({kHouse}, {.floor = 30}), InputError) << "empty: the roof is at 30 m";
  EXPECT_THROW(made({kHouse}, {.ceiling = nan}), InputError);
  const std::vector<Aabb> flat = {{{0, 0, 2}, {9, 9, 2}}};
  EXPECT_TRUE(support::says(support::refusal_of([&] { made(flat, {}); }), "give --ceiling"));
  EXPECT_NO_THROW(made(flat, {.ceiling = 30}));
  EXPECT_THROW(made({{{0, 0, 0}, {2, 2, 2}}}, {.scale = 1e8}), InputError);
  EXPECT_THROW(made({kHouse}, {.inflate = 1e9}), InputError);
}

TEST(MakeMap, RefusesBoxesFarFromTheOriginTheyCountFrom) {
  const Frame frame{Axes::enu, GeodeticOrigin{60, 25, 0}, ""};
  const auto at = [&](double x) { return std::vector<Aabb>{{{x, 0, 0}, {x + 9, 9, 9}}}; };
  EXPECT_NO_THROW(made(at(199e3), {}, frame));
  EXPECT_THROW(made(at(201e3), {}, frame), InputError);
  EXPECT_NO_THROW(made(at(201e3), {})) << "no origin";
  EXPECT_NO_THROW(made(at(201e3), {}, {Axes::enu, frame.origin, "EPSG:3879"}));
}

}  // namespace
}  // namespace geom
