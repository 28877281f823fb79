#include "geom/map/join.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "geom/map/geographic_frame.h"
#include "support/random_city.h"

namespace geom {
namespace {

BoxMap map_at(const Frame& frame, std::vector<Aabb> boxes) {
  return {{.frame = frame, .bounds = {{-1000, -1000, 0}, {1000, 1000, 100}}},
          support::table_of(std::move(boxes))};
}

Frame at(double latitude, double longitude, Axes axes = Axes::enu) {
  return {axes, GeodeticOrigin{latitude, longitude, 0}, ""};
}

TEST(InFrame, LeavesTheSameFrameAlone) {
  const BoxMap map = map_at(at(60, 25), {{{0, 0, 0}, {10, 20, 30}}});
  EXPECT_TRUE(in_frame(at(60, 25), map, "b").boxes[0] == map.boxes()[0]);
}

TEST(InFrame, BringsOriginsTogether) {
  // A thousandth of a degree north is 111.4 m at 60 degrees on WGS 84, and east 55.8 m.
  const BoxMap map = map_at(at(60.001, 25.001), {{{0, 0, 0}, {10, 20, 30}}});
  const Aabb box = in_frame(at(60, 25), map, "b").boxes[0];
  EXPECT_NEAR(box.min.x(), 55.80, 0.01);
  EXPECT_NEAR(box.min.y(), 111.41, 0.01);
  EXPECT_LT((box.max - box.min - Vec3(10, 20, 30)).cwiseAbs().maxCoeff(), 0.01);
  EXPECT_GE((box.max - box.min - Vec3(10, 20, 30)).minCoeff(), 0);
}

// Wherever a point of the box lies on Earth, there the moved box holds it.
TEST(InFrame, HoldsEveryPointOfEachBox) {
  for (const double latitude : {0.5, 37.8, 60.0, 75.0}) {
    for (const double apart : {0.001, 0.05, 0.5}) {
      const Frame to = at(latitude, 25);
      const Frame from = at(latitude + apart, 25 - apart);
      const BoxMap map = map_at(from, {{{-30, 10, 0}, {70, 40, 30}},
                                       {{900, -900, 0}, {1000, 900, 5}},
                                       {{-9000, -9000, 3}, {9000, 9000, 5}}});
      const BoxTable moved = in_frame(to, map, "b");
      const GeographicFrame there(*from.origin);
      const GeographicFrame here(*to.origin);
      for (std::size_t i = 0; i < moved.boxes.size(); ++i) {
        const Aabb& box = map.boxes()[i];
        for (int k = 0; k <= 40 * 40; ++k) {
          const double x = box.min.x() + (box.max.x() - box.min.x()) * (k / 41) / 40;
          const double y = box.min.y() + (box.max.y() - box.min.y()) * (k % 41) / 40;
          double lat, lon;
          Vec3 p(0, 0, box.min.z());
          there.to_geodetic(x, y, lat, lon);
          here.from_geodetic(lat, lon, p.x(), p.y());
          ASSERT_TRUE(contains(moved.boxes[i], p)) << latitude << " " << apart << " box " << i;
        }
      }
    }
  }
}

TEST(InFrame, SwapsAxesWhereNorthComesFirst) {
  const BoxMap map = map_at(at(60.001, 25.001, Axes::neu), {{{0, 0, 0}, {10, 20, 30}}});
  const Aabb box = in_frame(at(60, 25, Axes::neu), map, "b").boxes[0];
  EXPECT_NEAR(box.min.x(), 111.41, 0.01);
  EXPECT_NEAR(box.min.y(), 55.80, 0.01);
}

TEST(InFrame, RefusesWhatCannotBeBroughtTogether) {
  const BoxMap map = map_at({}, {{{0, 0, 0}, {1, 1, 1}}});
  EXPECT_THROW(in_frame(at(60, 25), map, "b"), InputError);
  EXPECT_THROW(in_frame({Axes::neu, {}, ""}, map, "b"), InputError);
}

TEST(InFrame, TakesNoUnknownHeightForADifference) {
  Frame known = at(60.001, 25);
  known.origin->height = 400;
  EXPECT_THROW(in_frame(at(60, 25), map_at(known, {{{0, 0, 0}, {1, 1, 20}}}), "b"), InputError);
  EXPECT_THROW(in_frame(known, map_at(at(60, 25), {{{0, 0, 0}, {1, 1, 20}}}), "b"), InputError);
  Frame higher = at(60, 25);
  higher.origin->height = 410;
  const BoxTable moved = in_frame(known, map_at(higher, {{{0, 0, 0}, {1, 1, 20}}}), "b");
  EXPECT_NEAR(moved.boxes[0].min.z(), 10, 1e-9);
}

TEST(Append, UnitesLabels) {
  BoxTable a = support::table_of({{{0, 0, 0}, {1, 1, 1}}});
  BoxTable b = a;
  b.labels = {"", "tree"};
  b.label = {1};
  append(a, b);
  append(a, b);
  EXPECT_EQ(a.labels, (std::vector<std::string>{"", "tree"}));
  EXPECT_EQ(a.label, (std::vector<std::uint32_t>{0, 1, 1}));
}

}  // namespace
}  // namespace geom
