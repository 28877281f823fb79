#include "geom/join.h"

#include <gtest/gtest.h>

#include <sstream>

#include "geom/error.h"
#include "geom/io/keep_out.h"
#include "support/random_city.h"

namespace geom {
namespace {

BoxMap map_at(const Frame& frame, std::vector<Aabb> boxes) {
  BoxMapSpec spec;
  spec.frame = frame;
  spec.bounds = {{-1000, -1000, 0}, {1000, 1000, 100}};
  return {spec, support::table_of(std::move(boxes))};
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

TEST(KeepOut, StandsWhereItsDegreesSay) {
  std::istringstream in(
      R"({"type":"Feature","properties":{"lower":10,"upper":50,"name":"port"},"geometry":
         {"type":"Polygon","coordinates":[[[25,60],[25.001,60],[25.001,60.001],[25,60.001],[25,60]]]}})");
  const KeepOut zones = read_keep_out(in, "zones", at(60, 25), {});
  ASSERT_EQ(zones.volumes.size(), 1u);
  EXPECT_EQ(zones.labels[0], "keep-out: port");
  EXPECT_EQ(zones.volumes[0].bottom, 10);
  EXPECT_EQ(zones.volumes[0].top, 50);
  EXPECT_NEAR(zones.volumes[0].polygon.outer[2].x(), 55.80, 0.01);
  EXPECT_NEAR(zones.volumes[0].polygon.outer[2].y(), 111.41, 0.01);
}

TEST(KeepOut, RefusesWhatIsNoVolume) {
  for (
      const char* text :
      {"", "[]", R"({"type":"Point","coordinates":[1,2]})",
       R"({"type":"Polygon","coordinates":[[[0,0],[1,1],[0,0]]]})",
       R"({"type":"Polygon","coordinates":[[[0,0],[200,1],[1,1],[0,0]]]})",
       R"({"type":"Feature","properties":{"lower":9,"upper":3},"geometry":{"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,0]]]}})"}) {
    std::istringstream in(text);
    EXPECT_THROW(read_keep_out(in, "zones", at(60, 25), {}), InputError) << text;
  }
  std::istringstream in(R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,0]]]})");
  EXPECT_THROW(read_keep_out(in, "zones", {}, {}), InputError);
}

}  // namespace
}  // namespace geom
