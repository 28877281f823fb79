// A camera on a vehicle: where it looks, and which texts are none.

#include "geom/picture/camera.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "geom/base/error.h"

namespace {

using geom::Vec3;
using geom::picture::View;

TEST(Camera, LooksAlongTheBodysXByDefault) {
  geom::picture::Pose pose;
  pose.position = {1, 2, 3};
  const View view = geom::picture::view_from({}, pose);
  EXPECT_EQ(view.eye, pose.position);
  EXPECT_EQ(view.axes.col(2), Vec3::UnitX());
  EXPECT_EQ(view.axes.col(0), Vec3(-Vec3::UnitY()));  // left of the body is left in the picture
  EXPECT_EQ(view.axes.col(1), Vec3(-Vec3::UnitZ()));
}

geom::picture::Camera camera(const char* json) {
  return geom::picture::parse_camera(geom::JsonFields(json, "camera.json", 0));
}

TEST(Camera, IsMountedByPositionAndAngles) {
  const auto down = camera(R"({"width":100,"height":50,"fx":80,"position":[0.1,0,-0.2],)"
                           R"("pitch_deg":90})");
  const View view = geom::picture::view_from(down, {});
  EXPECT_EQ(view.eye, Vec3(0.1, 0, -0.2));
  EXPECT_NEAR((view.axes.col(2) + Vec3::UnitZ()).norm(), 0, 1e-15);
  EXPECT_EQ(view.fy, 80);
  EXPECT_EQ(view.cx, 49.5);
  EXPECT_EQ(view.cy, 24.5);
}

TEST(Camera, RefusesWhatCannotBe) {
  for (const char* json :
       {R"({"height":50,"fx":80})", R"({"width":0,"height":50,"fx":80})",
        R"({"width":10.5,"height":50,"fx":80})", R"({"width":100,"height":99999,"fx":80})",
        R"({"width":100,"height":50,"fx":0})", R"({"width":100,"height":50,"fx":80,"fy":-1})",
        R"({"width":100,"height":50,"fx":80,"pitch_deg":1e9})",
        R"({"width":100,"height":50,"fx":80,"position":[1,2]})"}) {
    EXPECT_THROW(camera(json), geom::InputError) << json;
  }
}

}  // namespace
