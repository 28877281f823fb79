// What public functions of the library do with arguments that are none: they say so, or the answer
// is right all the same.

#include "geom/base/precondition.h"

#include <gtest/gtest.h>

#include <limits>

#include "geom/base/error.h"
#include "geom/collision/collision.h"
#include "geom/map/box_index.h"
#include "geom/map/column_grid.h"
#include "geom/map/ground_grid.h"
#include "geom/shape/cover.h"
#include "support/exact_oracle.h"
#include "support/random_city.h"

namespace geom {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNotFinite[] = {kNan, -kNan, kInfinity, -kInfinity};
constexpr double kHuge[] = {1e10, -1e10, 1e18, 1e39, 1e150, 1e300, -1e300, 1.7e308, -1.7e308};
constexpr double kNoLength[] = {kNan, -1, -1e-300, -1e300, -kInfinity};
const Vehicle kVehicle{"box", {1, 1, 0.5}};
const Vec3 kInside(0, 1, 41);  // of the box that spans every random city
const Vec3 kAbove(0, 1, 119);

class QueryArguments : public testing::TestWithParam<std::size_t> {  // boxes a group
 protected:
  CollisionScene scene_{
      support::random_city(41, 300, 600), kVehicle, 0.25, {std::size_t{1} << 29, GetParam()}};
};

TEST_P(QueryArguments, PointsThatAreNoneAreRefused) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const Vec3& at : {kInside, kAbove}) {
      const auto each = [&](double wrong) {
        Vec3 p = at;
        p[axis] = wrong;
        EXPECT_THROW(scene_.hits(p), InputError) << wrong;
        EXPECT_THROW(scene_.hits(at, p), InputError) << wrong;
        EXPECT_THROW(scene_.hits(p, at), InputError) << wrong;
        EXPECT_THROW(scene_.nearest(p, kInfinity), InputError) << wrong;
        EXPECT_THROW(scene_.nearest(p, 5, 3), InputError) << wrong;
        EXPECT_THROW(scene_.sweep_hits(at, p, {2, 2, 2}), InputError) << wrong;
        EXPECT_THROW(scene_.separating_planes(at, p, 5), InputError) << wrong;
        EXPECT_FALSE(scene_.inside_bounds(p)) << wrong;
        EXPECT_FALSE(scene_.free(at, p)) << wrong;
        EXPECT_FALSE(scene_.free(p, at)) << wrong;
        EXPECT_FALSE(scene_.empty_box(at, p, 5)) << wrong;
        const std::pair<Vec3, Vec3> segments[] = {{kAbove, kAbove}, {at, p}};
        EXPECT_THROW(scene_.hits(segments, {2, {}}), InputError) << wrong;
      };
      for (const double wrong : kNotFinite) each(wrong);
      for (const double wrong : kHuge) each(wrong);
    }
  }
}

TEST_P(QueryArguments, FarAwayIsAnsweredRight) {
  for (const double far : {1e5, 1e7, 1e8, kFarthest}) {
    for (const double sign : {1.0, -1.0}) {
      const Vec3 p(sign * far, 1, 41);
      EXPECT_TRUE(scene_.hits(p, kInside)) << far;
      EXPECT_TRUE(scene_.hits(p, {-p.x(), 1, 41})) << far;
      EXPECT_FALSE(scene_.hits(p, {p.x(), -1e9, 41})) << far;
      EXPECT_TRUE(scene_.sweep_hits(p, {-p.x(), 1, 41}, {2, 2, 2})) << far;
      const auto found = scene_.nearest(p, kInfinity);
      ASSERT_TRUE(found);
      double least = kInfinity;
      for (std::size_t i = 0; i < scene_.map().size(); ++i) {
        least = std::min(least, distance(p, grow(scene_.map().box(i), kVehicle.half)));
      }
      EXPECT_EQ(found->distance, least) << far;
    }
  }
}

TEST_P(QueryArguments, RegionsMayBeInfiniteAndNeverInvertedOrNone) {
  std::vector<std::size_t> all(scene_.map().size());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
  for (const double far : {1e9, 1e20, 1e300, 1.7e308, kInfinity}) {
    const Vec3 corner = Vec3::Constant(far);
    EXPECT_EQ(scene_.boxes_meeting({-corner, corner}), all) << far;
    EXPECT_FALSE(scene_.boxes_meeting({-corner, corner}, 3)) << far;
    EXPECT_TRUE(scene_.boxes_meeting({corner, corner}).empty()) << far;
    EXPECT_EQ(scene_.boxes_meeting({kInside - corner, kInside + corner}), all) << far;
    EXPECT_EQ(scene_.separating_planes(kAbove, kAbove, far).size(), all.size()) << far;
  }
  EXPECT_THROW(scene_.boxes_meeting({{0, 0, 1}, {1, 1, 0}}), InputError);
  for (int axis = 0; axis < 3; ++axis) {
    Aabb region{-kAbove, kAbove};
    region.max[axis] = kNan;
    EXPECT_THROW(scene_.boxes_meeting(region), InputError);
    std::swap(region.min, region.max);
    EXPECT_THROW(scene_.boxes_meeting(region, 3), InputError);
  }
}

TEST_P(QueryArguments, LengthsThatAreNoneAreRefused) {
  EXPECT_THROW(scene_.nearest(kAbove, kNan), InputError);
  EXPECT_THROW(scene_.nearest(kAbove, kNan, 3), InputError);
  for (const double radius : {-1e-300, -1.0, -1e300, -kInfinity}) {
    EXPECT_FALSE(scene_.nearest(kInside, radius)) << radius;  // nothing is nearer than here
  }
  EXPECT_EQ(scene_.nearest(kInside, 0)->distance, 0);
  for (const double wrong : kNoLength) {
    EXPECT_THROW(scene_.sweep_hits(kAbove, kAbove, {1, wrong, 1}), InputError) << wrong;
    EXPECT_THROW(scene_.separating_planes(kAbove, kAbove, wrong), InputError) << wrong;
    EXPECT_THROW(scene_.empty_box(kAbove, kAbove, wrong), InputError) << wrong;
  }
  for (const double wrong : {kInfinity, 1e9, 1e300}) {
    EXPECT_THROW(scene_.sweep_hits(kAbove, kAbove, {1, wrong, 1}), InputError) << wrong;
  }
  EXPECT_TRUE(scene_.sweep_hits(kAbove, kAbove, Vec3::Constant(1e8)));
}

INSTANTIATE_TEST_SUITE_P(BoxesAGroup, QueryArguments, testing::Values(10, 4096));

TEST(SceneArguments, SizesThatAreNoneAreRefused) {
  const BoxMap map = support::random_city(42, 20, 100);
  const auto each = [&](double wrong) {
    EXPECT_THROW(CollisionScene(map, kVehicle, wrong), InputError) << wrong;
    for (int axis = 0; axis < 3; ++axis) {
      Vehicle vehicle = kVehicle;
      vehicle.half[axis] = wrong;
      EXPECT_THROW(CollisionScene(map, vehicle, 0), InputError) << wrong;
    }
  };
  for (const double wrong : kNoLength) each(wrong);
  for (const double wrong : {kInfinity, 1e9, 1e150, 1e300, 1.7e308}) each(wrong);
}

TEST(SceneArguments, TheLargestSizesHitEverywhere) {
  const CollisionScene scene(support::random_city(42, 20, 100), {"box", Vec3::Constant(1e8)}, 1e8);
  EXPECT_TRUE(scene.hits(kAbove));
  EXPECT_FALSE(scene.free(kAbove));
  EXPECT_FALSE(scene.free_bounds());
  EXPECT_TRUE(scene.hits({1.5e8, 0, 0}));
  EXPECT_FALSE(scene.hits({2.5e8, 0, 0}));
}

TEST(SceneArguments, NoBoxesAGroupIsOne) {
  const CollisionScene scene(support::random_city(42, 20, 100), kVehicle, 0, {0, 0});
  EXPECT_TRUE(scene.hits(kInside));
}

TEST(SceneArguments, AMapThatReachesTooFarIsRefused) {
  for (const double far : {1e10, 1e19, 1e300}) {
    BoxMapSpec spec;
    spec.tile_size = far;
    const Aabb box{Vec3::Constant(-far), Vec3::Constant(far)};
    EXPECT_THROW(CollisionScene(BoxMap(spec, support::table_of({box})), kVehicle, 0), InputError);
  }
}

TEST(SegmentHits, IsRightForFiniteCoordinatesOfAnySize) {
  support::Random random(43);
  const double sizes[] = {1, 1e9, 1e100, 1e155, 1e200, 1e300, 1.7e308};
  int hits = 0;
  for (int i = 0; i < 100000; ++i) {
    const auto point = [&] {
      Vec3 p;
      for (double& v : p) {
        v = (random.below(3) ? random.uniform(-1, 1) : random.stepped(-1, 1, 0.5)) *
            sizes[random.below(7)];
      }
      return p;
    };
    const Vec3 a = point(), b = point(), c = point(), d = point();
    const Aabb box{c.cwiseMin(d), c.cwiseMax(d)};
    const bool expected = oracle::segment_hits(a, b, box);
    hits += expected;
    ASSERT_EQ(segment_hits(a, b, box), expected) << i;
    ASSERT_GE(distance(a, box), contains(box, a) ? 0 : std::numeric_limits<double>::denorm_min());
  }
  EXPECT_GT(hits, 1000);
}

TEST(SegmentHits, NeverMissesByWhatIsNotANumber) {
  const Aabb box{{0, 0, 0}, {1, 1, 1}};
  for (int axis = 0; axis < 3; ++axis) {
    for (const double other : {-1.0, 0.5, 2.0}) {
      Vec3 p(0.5, 0.5, 0.5);
      Vec3 q = p;
      p[axis] = kNan;
      q[axis] = other;
      EXPECT_TRUE(segment_hits(p, q, box));
      EXPECT_TRUE(segment_hits(q, p, box));
      EXPECT_TRUE(segment_hits(p, p, box));
    }
  }
}

TEST(BoxDistance, OverflowsOnlyWhereItIsTooLarge) {
  const Aabb box{{0, 0, 0}, {1, 1, 1}};
  EXPECT_EQ(distance({1e300, 0.5, 0.5}, box), 1e300);
  EXPECT_EQ(distance({-1e200, 0, 0}, box), 1e200);
  EXPECT_NEAR(distance({3e200, 4e200, 0}, box) / 5e200, 1, 1e-12);
}

TEST(Separation, RefusesWhatIsNoSegmentOrBox) {
  const Aabb box{{0, 0, 0}, {1, 1, 1}};
  const auto each = [&](double wrong) {
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 p = kAbove;
      p[axis] = wrong;
      EXPECT_THROW(separation(p, kAbove, box), InputError);
      EXPECT_THROW(separation(kAbove, p, box), InputError);
      EXPECT_THROW(distance(p, kAbove, box), InputError);
      Aabb far = box;
      far.max[axis] = wrong;
      EXPECT_THROW(distance(kAbove, kAbove, far), InputError);
      EXPECT_THROW(separation(kAbove, kAbove, far), InputError);
    }
  };
  for (const double wrong : kNotFinite) each(wrong);
  for (const double wrong : kHuge) each(wrong);
}

TEST(EmptyBoxArguments, ObstaclesThatAreNoneAreRefused) {
  const Aabb limits{{0, 0, 0}, {9, 9, 9}};
  const Aabb seed{{1, 1, 1}, {2, 2, 2}};
  const Aabb wrong[] = {
      {{4, 4, kNan}, {5, 5, 5}}, {{4, 4, 4}, {5, kNan, 5}}, {{5, 4, 4}, {4, 5, 5}}};
  for (const Aabb& obstacle : wrong) {
    EXPECT_THROW(empty_box(seed, limits, std::span(&obstacle, 1)), InputError);
  }
  EXPECT_FALSE(empty_box({{1, 1, kNan}, {2, 2, 2}}, limits, {}));
}

TEST(BoxIndexArguments, AreRefusedWhereTheyAreNone) {
  for (const double cell : {kNan, 0.0, -1.0, 1e-300, 1e300, kInfinity}) {
    EXPECT_THROW(BoxIndex{cell}, InputError) << cell;
  }
  BoxIndex index(1);
  index.add(0, {{0, 0, 0}, {1, 1, 1}});
  const auto each = [&](double wrong) {
    EXPECT_THROW(index.add(1, {{wrong, 0, 0}, {wrong, 1, 1}}), InputError) << wrong;
    EXPECT_THROW(index.near({{0, -1, 0}, {1, wrong, 1}}), InputError) << wrong;
  };
  for (const double wrong : kNotFinite) each(wrong);
  for (const double wrong : kHuge) each(wrong);
  EXPECT_EQ(index.near({Vec3::Constant(-1e9), Vec3::Constant(1e9)}).size(), 1u);
}

TEST(ColumnArguments, AreRefusedWhereTheyAreNone) {
  for (const double wrong : {kNan, 0.0, -1.0, kInfinity}) {
    EXPECT_THROW(ColumnGrid({wrong, 0.5, 2, false}), InputError) << wrong;
    EXPECT_THROW(ColumnGrid({1, wrong, 2, false}), InputError) << wrong;
    EXPECT_THROW(GroundGrid({wrong, 0.1, 0.3}), InputError) << wrong;
  }
  ColumnGrid grid({});
  GroundGrid ground({});
  for (int axis = 0; axis < 3; ++axis) {
    const auto each = [&](double wrong) {
      Vec3 p(1, 2, 3);
      p[axis] = wrong;
      EXPECT_THROW(grid.add(p), InputError) << wrong;
      if (axis < 2) {
        EXPECT_THROW(ground.add(p), InputError) << wrong;
      }
    };
    for (const double wrong : kNotFinite) each(wrong);
    for (const double wrong : kHuge) each(wrong);
  }
}

TEST(CoverArguments, AreRefusedWhereTheyAreNone) {
  const Polygon square{{{0, 0}, {9, 0}, {9, 9}, {0, 9}}, {}};
  for (const double slack : {kNan, 0.0, -1.0, 1e-9, kInfinity}) {
    EXPECT_THROW(cover(square, slack), InputError) << slack;
  }
  const auto each = [&](double wrong) {
    Polygon polygon = square;
    polygon.outer[2].x() = wrong;
    EXPECT_THROW(cover(polygon, 1), InputError) << wrong;
  };
  for (const double wrong : kNotFinite) each(wrong);
  for (const double wrong : kHuge) each(wrong);
}

}  // namespace
}  // namespace geom
