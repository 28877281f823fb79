#include "import/sdf/sdf_shapes.h"

#include <gtest/gtest.h>

#include "support/reading.h"

namespace geom {
namespace {

struct Made {
  SdfBoxes out;
  Skipped skipped;
};

Made made(const std::string& geometry, const std::string& pose = "", double slack = 0.1) {
  const XmlElement shape = parse_xml("<geometry>" + geometry + "</geometry>", "w");
  const XmlElement place = parse_xml("<pose degrees='true'>" + pose + "</pose>", "w");
  const std::string source = "w";
  Made m;
  const SdfOptions options;
  SdfMeshes meshes(options, m.skipped);
  m.out = SdfShapes(slack, meshes, m.skipped)
              .boxes_of({&shape, &source}, parse_sdf_pose({&place, &source}));
  return m;
}

Aabb around(const Made& m) { return *bounds(m.out.boxes); }

TEST(SdfShapes, ABoxIsExact) {
  const Made m = made("<box><size>4 2 6</size></box>", "1 2 3 0 0 90");
  ASSERT_EQ(m.out.boxes.size(), 1u);
  EXPECT_EQ(m.out.boxes[0], (Aabb{{0, 0, 0}, {2, 4, 6}}));
}

TEST(SdfShapes, RoundBodiesAreCovered) {
  for (const char* text :
       {"<cylinder><radius>1</radius><length>2</length></cylinder>",
        "<sphere><radius>1</radius></sphere>", "<ellipsoid><radii>1 1 1</radii></ellipsoid>",
        "<capsule><radius>1</radius><length>0</length></capsule>",
        "<cone><radius>1</radius><length>2</length></cone>"}) {
    const Aabb box = around(made(text, "5 0 0 0 0 30"));
    for (int i = 0; i < 3; ++i) {
      EXPECT_LE(box.min[i], (i == 0 ? 4 : -1) + 1e-12) << text;
      EXPECT_GE(box.min[i], (i == 0 ? 4 : -1) - 0.1) << text;
      EXPECT_GE(box.max[i], (i == 0 ? 6 : 1) - 1e-12) << text;
      EXPECT_LE(box.max[i], (i == 0 ? 6 : 1) + 0.1) << text;
    }
  }
}

constexpr const char* kOutline =
    "<polyline><point>0 0</point><point>9 0</point><point>9 9</point><point>0 9</point>"
    "<height>2</height></polyline>";
constexpr const char* kHole =
    "<polyline><point>3 3</point><point>6 3</point><point>6 6</point><point>3 6</point>"
    "<height>2</height></polyline>";

TEST(SdfShapes, PolylinesStandOnTheirPlaceAndHaveHoles) {
  EXPECT_NEAR(around(made(kOutline, "0 0 5 0 0 0")).min.z(), 5, 1e-8);
  EXPECT_NEAR(around(made(kOutline, "0 0 5 0 0 0")).max.z(), 7, 1e-8);
  EXPECT_NEAR(around(made(kOutline, "0 0 5 180 0 0")).min.z(), 3, 1e-8);
  const Made open = made(std::string(kOutline) + kHole);
  for (const Aabb& b : open.out.boxes) EXPECT_FALSE(contains(b, {4.5, 4.5, 1}));
}

// On its side: what was up is along -y, and the hole goes through.
TEST(SdfShapes, PolylinesMayBeTilted) {
  const Made side = made(std::string(kOutline) + kHole, "0 0 5 90 0 0");
  EXPECT_TRUE(side.skipped.empty());
  const auto held = [&](const Vec3& p) {
    return std::any_of(side.out.boxes.begin(), side.out.boxes.end(),
                       [&](const Aabb& b) { return contains(b, p); });
  };
  for (const Vec3& p : {Vec3(1, -1, 6), Vec3(8, -2, 13.9), Vec3(4.5, 0, 5.5), Vec3(0, -1, 9)}) {
    EXPECT_TRUE(held(p)) << p.transpose();
  }
  EXPECT_FALSE(held({4.5, -1, 9.5}));
  EXPECT_NEAR(around(side).min.y(), -2, 0.1);
  EXPECT_NEAR(around(side).max.z(), 14, 0.1);
}

TEST(SdfShapes, APlaneIsAFloorOrARectangle) {
  const std::string plane = "<plane><normal>0 0 2</normal><size>10 4</size></plane>";
  EXPECT_EQ(made(plane, "0 0 3 0 0 45").out.plane, 3);
  EXPECT_EQ(made(plane, "0 0 3 0 0 0").out.boxes[0], (Aabb{{-5, -2, 3}, {5, 2, 3}}));
  EXPECT_FALSE(made(plane, "0 0 3 180 0 0").out.plane);
  EXPECT_FALSE(made(plane, "0 0 3 0.001 0 0").out.plane);
  const Made wall = made("<plane><normal>1 0 0</normal><size>10 4</size></plane>", "7 0 0 0 0 0");
  EXPECT_FALSE(wall.out.plane);
  EXPECT_NEAR(around(wall).min.x(), 7, 0.1);
  EXPECT_NEAR(around(wall).max.x(), 7, 0.1);
  EXPECT_NE(support::refusal_of([] { made("<plane><normal>0 0 0</normal></plane>"); }), "");
}

TEST(SdfShapes, SkipsWhatItCannotBuild) {
  for (const char* text : {"<mesh><uri>a.dae</uri></mesh>", "<heightmap/>", "<image/>", "<blob/>",
                           "<drake:capsule/>"}) {
    EXPECT_EQ(made(text).skipped.count(), 1u) << text;
  }
  EXPECT_EQ(made("<empty/>").skipped.count(), 0u);
}

TEST(SdfShapes, RefusesSizesThatAreNone) {
  for (const char* text :
       {"", "<box/>", "<box><size>1 1</size></box>", "<box><size>1 1 -1</size></box>",
        "<box><size>0 0 0</size></box>", "<box><size>1 1 1m</size></box>",
        "<box><size>nan 1 1</size></box>", "<sphere><radius>0</radius></sphere>",
        "<sphere><radius>-1</radius></sphere>", "<cylinder><radius>1</radius></cylinder>",
        "<sphere><radius>1e7</radius></sphere>", "<empty/><box><size>1 1 1</size></box>",
        "<plane/><box><size>1 1 1</size></box>",
        "<polyline><point>0 0</point><point>1 0</point></polyline>",
        "<polyline><point>0 0</point><point>1 0</point><point>1 1</point><height>0</height>"
        "</polyline>"}) {
    EXPECT_NE(support::refusal_of([&] { made(text); }), "") << text;
  }
}

}  // namespace
}  // namespace geom
