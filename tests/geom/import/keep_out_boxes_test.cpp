#include "geom/import/keep_out_boxes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "geom/base/usage_error.h"
#include "support/random_city.h"
#include "support/reading.h"

namespace geom {
namespace {

BoxMapSpec spec_at_origin() {
  return {.frame = {.origin = GeodeticOrigin{60, 25, 0}}, .bounds = {{0, 0, 0}, {100, 100, 40}}};
}

std::string polygon(const std::string& ring) {
  return R"({"type":"Feature","properties":{"lower":5,"upper":20,"name":"port"},"geometry":
           {"type":"Polygon","coordinates":[[)" +
         ring + "]]}}";
}

BoxTable boxes_of(const std::string& text, const BoxMapSpec& spec, const VolumeOptions& options) {
  return keep_out_boxes(read_volumes(text, "zones", spec, options), "zones", spec, options);
}

TEST(KeepOutBoxes, HoldEveryPointOfTheVolume) {
  support::Random random(7);
  for (int i = 0; i < 200; ++i) {
    Vec2 p[3];
    for (Vec2& corner : p) corner = {random.uniform(0, 90), random.uniform(0, 90)};
    std::string ring;
    for (const int k : {0, 1, 2, 0}) {
      ring += fmt::format("{}[{},{}]", ring.empty() ? "" : ",", p[k].x(), p[k].y());
    }
    const Vec2 a = p[1] - p[0];
    const Vec2 b = p[2] - p[0];
    if (std::abs(a.x() * b.y() - a.y() * b.x()) < 1) continue;
    const BoxTable table = boxes_of(polygon(ring), spec_at_origin(), {.local = true});
    for (int k = 0; k < 50; ++k) {
      const double u = random.uniform(0, 1);
      const double v = random.uniform(0, 1 - u);
      const Vec2 inside = p[0] + u * a + v * b;
      const Vec3 at(inside.x(), inside.y(), random.uniform(5, 20));
      ASSERT_TRUE(std::any_of(table.boxes.begin(), table.boxes.end(),
                              [&](const Aabb& box) { return contains(box, at); }))
          << "case " << i;
    }
    for (const Aabb& box : table.boxes) {
      ASSERT_EQ(box.min.z(), 5);
      ASSERT_EQ(box.max.z(), 20);
    }
  }
}

TEST(KeepOutBoxes, RefuseAVolumeElsewhereUnlessFar) {
  const std::string elsewhere = polygon("[30,10],[30.001,10],[30.001,10.001],[30,10]");
  const BoxMapSpec spec = spec_at_origin();
  EXPECT_TRUE(
      support::says(support::refusal_of([&] { boxes_of(elsewhere, spec, {}); }), "near the map"));
  EXPECT_FALSE(boxes_of(elsewhere, spec, {.far = true}).boxes.empty());
}

TEST(KeepOutBoxes, RefuseSidesThatWouldTakeTenThousandBoxes) {
  const std::string sloping = polygon("[0,0],[90,80],[0,80],[0,0]");
  const std::string said = support::refusal_of(
      [&] { boxes_of(sloping, spec_at_origin(), {.local = true, .slack = 0.008}); });
  EXPECT_TRUE(support::says(said, "feature 0: expected sloping sides of at most 80 m"));
  EXPECT_TRUE(support::says(said, "give --slack"));
}

TEST(ReadVolumes, RefusesOptionsOfTheOtherForm) {
  const std::string f3548 = R"({"volumes":[]})";
  EXPECT_THROW(read_volumes(f3548, "zones", spec_at_origin(), {.local = true}), UsageError);
  EXPECT_THROW(read_volumes(polygon("[0,0],[1,0],[0,1],[0,0]"), "zones", spec_at_origin(),
                            {.zero_height = 3}),
               UsageError);
}

}  // namespace
}  // namespace geom
