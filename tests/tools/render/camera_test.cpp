// Where a camera is and looks, and what moves it.

#include "render/camera/camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "geom/base/error.h"
#include "render/camera/motion.h"
#include "render/camera/view.h"
#include "support/random_city.h"

namespace {

using geom::Aabb;
using geom::Axes;
using render::Rays;
using render::Vec3;
using render::View;
using support::Random;

TEST(Camera, LooksAlongTheBodysXByDefault) {
  render::Pose pose;
  pose.position = {1, 2, 3};
  const View view = render::view_from({}, pose);
  EXPECT_EQ(view.eye, pose.position);
  EXPECT_EQ(view.axes.col(2), Vec3::UnitX());
  EXPECT_EQ(view.axes.col(0), Vec3(-Vec3::UnitY()));  // left of the body is left in the picture
  EXPECT_EQ(view.axes.col(1), Vec3(-Vec3::UnitZ()));
}

render::Camera camera(const char* json) {
  return render::parse_camera(geom::JsonFields(json, "camera.json", 0));
}

TEST(Camera, IsMountedByPositionAndAngles) {
  const auto down = camera(R"({"width":100,"height":50,"fx":80,"position":[0.1,0,-0.2],)"
                           R"("pitch_deg":90})");
  const View view = render::view_from(down, {});
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

TEST(ViewProperty, ProjectionUndoesTheRay) {
  Random random(26);
  for (int i = 0; i < 200; ++i) {
    View view = render::overview({{-50, -80, 0}, {70, 90, 40}}, 400, 300, {});
    if (i % 2) view = render::plan_view({{-50, -80, 0}, {70, 90, 40}}, 400, 300);
    const double u = random.uniform(0, 400);
    const double v = random.uniform(0, 300);
    const double depth = random.uniform(1, 500);
    const auto ray = Rays(view).through(u, v);
    const Vec3 back = render::project(view, ray.origin + depth * ray.direction);
    EXPECT_NEAR((back - Vec3(u, v, depth)).norm(), 0, 1e-7) << "seed 26, case " << i;
  }
}

TEST(ViewProperty, AnOverviewHoldsAllOfTheRegionAndFillsThePicture) {
  Random random(27);
  for (int i = 0; i < 200; ++i) {
    const Aabb region{{0, 0, 0},
                      {random.uniform(1, 900), random.uniform(1, 900), random.uniform(1, 200)}};
    const View view =
        render::overview(region, 640, 480, {random.uniform(-3, 3), random.uniform(0.1, 1.5), 0.7});
    double least = 1e9;
    for (int k = 0; k < 8; ++k) {
      const Vec3 corner(k & 1 ? region.max.x() : 0, k & 2 ? region.max.y() : 0,
                        k & 4 ? region.max.z() : 0);
      const Vec3 at = render::project(view, corner);
      EXPECT_GT(at.z(), 0) << "seed 27, case " << i;
      const double room = std::min({at.x(), 639 - at.x(), at.y(), 479 - at.y()});
      EXPECT_GT(room, 0) << "seed 27, case " << i;
      least = std::min(least, room);
    }
    EXPECT_LT(least, 60) << "seed 27, case " << i;
  }
}

traj::Trajectory bend() {
  traj::Trajectory out;
  traj::State a, b, c;
  b.position = {20, 5, 8};
  b.velocity = {3, 2, 0};
  c.position = {30, 30, 4};
  out.segments = {traj::hermite(a, b, 8), traj::hermite(b, c, 9)};
  return out;
}

TEST(Motion, OfATrajectoryIsTheSameInBothFrames) {
  traj::Trajectory swapped = bend();
  for (traj::Segment& s : swapped.segments) {
    for (Vec3& p : s.point) p = geom::to_enu(Axes::neu, p);
  }
  const render::Motion enu("a", bend(), Axes::enu);
  const render::Motion neu("a", swapped, Axes::neu);
  for (double t = 0; t <= enu.end(); t += 0.25) {
    EXPECT_NEAR((enu.pose(t).position - neu.pose(t).position).norm(), 0, 1e-9);
    EXPECT_NEAR((enu.pose(t).attitude - neu.pose(t).attitude).norm(), 0, 1e-9) << t;
  }
}

TEST(Motion, OfAFlightIsLinearBetweenItsRows) {
  traj::FlightLog log;
  log.id = "f";
  for (int i = 0; i < 3; ++i) {
    traj::FlightSample s;
    s.time = 1 + i;
    s.position = Vec3(10 * i, i * i, 5);
    s.attitude = Eigen::AngleAxisd(0.4 * i, Vec3::UnitZ());
    s.setpoint_position = s.position + Vec3(0, 0, 0.5 * i);
    log.samples.push_back(s);
  }
  const render::Motion motion(log);
  EXPECT_EQ(motion.begin(), 1);
  EXPECT_EQ(motion.end(), 3);
  EXPECT_NEAR((motion.pose(1.5).position - Vec3(5, 0.5, 5)).norm(), 0, 1e-12);
  const Eigen::Matrix3d half = Eigen::AngleAxisd(0.6, Vec3::UnitZ()).toRotationMatrix();
  EXPECT_NEAR((motion.pose(2.5).attitude - half).norm(), 0, 1e-12);
  EXPECT_NEAR(motion.tracking_error(2.5), 0.75, 1e-12);
  EXPECT_EQ(motion.pose(99).position, log.samples.back().position);
  EXPECT_EQ(motion.pose(-1).position, log.samples.front().position);
}

}  // namespace
