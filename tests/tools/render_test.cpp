// Pictures against slow ones in double precision.

#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <cstring>
#include <sstream>

#include "cli/run.h"
#include "geom/error.h"
#include "render/camera_poses.h"
#include "render/frame_output.h"
#include "render/image_file.h"
#include "render/motion.h"
#include "render/png_image.h"
#include "render/take.h"
#include "support/city.h"
#include "support/random_city.h"

namespace {

using geom::Aabb;
using geom::Axes;
using render::Block;
using render::Hit;
using render::Rays;
using render::Vec3;
using render::View;
using support::Random;

// Where the ray enters the first box, by slabs in double; nothing where it meets none.
struct Entry {
  double depth = std::numeric_limits<double>::infinity();
  std::size_t box = 0;
};
Entry first_box(const render::Ray& ray, std::span<const Aabb> boxes) {
  Entry best;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    double enter = 0;
    double leave = best.depth;
    for (int axis = 0; axis < 3; ++axis) {
      const double slope = 1 / ray.direction[axis];
      const double a = (boxes[i].min[axis] - ray.origin[axis]) * slope;
      const double b = (boxes[i].max[axis] - ray.origin[axis]) * slope;
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    if (enter <= leave && enter < best.depth) best = {enter, i};
  }
  return best;
}

// What the picture ought to hold: boxes, then the plane of the ground, then 0 for the sky.
double depth_of(const render::PictureScene& scene, const render::Ray& ray) {
  double depth = first_box(ray, scene.boxes()).depth;
  const double ground = (scene.ground() - ray.origin.z()) / ray.direction.z();
  if (ground > 0) depth = std::min(depth, ground);
  return std::isfinite(depth) ? depth : 0;
}

bool agree(double a, double b) { return std::abs(a - b) <= 1e-4 * std::max(a, b); }

View random_view(Random& random, const render::PictureScene& scene, const Aabb& bounds) {
  for (;;) {
    render::Pose pose;
    for (int i = 0; i < 3; ++i) pose.position[i] = random.uniform(bounds.min[i], bounds.max[i]);
    const auto holds = [&](const Aabb& box) { return geom::distance(pose.position, box) < 0.5; };
    if (std::any_of(scene.boxes().begin(), scene.boxes().end(), holds)) continue;
    pose.attitude = Eigen::Quaterniond(random.uniform(-1, 1), random.uniform(-0.2, 0.2),
                                       random.uniform(-0.2, 0.2), random.uniform(-1, 1))
                        .normalized()
                        .toRotationMatrix();
    return render::view_from({}, pose);
  }
}

struct Comparison {
  std::size_t pixels = 0;
  std::size_t on_boxes = 0;
  std::size_t at_edges = 0;  // where a thousandth of a pixel decides
  std::size_t wrong = 0;
};

Comparison compare(const geom::BoxMap& map, std::uint64_t seed, std::size_t pixels) {
  const render::PictureScene scene(map, {});
  const Axes axes = map.spec().frame.axes;
  const Aabb bounds{geom::to_enu(axes, map.spec().bounds.min),
                    geom::to_enu(axes, map.spec().bounds.max)};
  Random random(seed);
  Comparison out;
  while (out.pixels < pixels) {
    const View view = random_view(random, scene, bounds);
    const Rays rays(view);
    for (int n = 0; n < 50; ++n) {
      const int x = random.below(view.width);
      const int y = random.below(view.height);
      const Block block = scene.cast(rays, x, y);
      const Hit& hit = block[0];
      ++out.pixels;
      out.on_boxes += hit.kind == Hit::Kind::box;
      const double depth = depth_of(scene, rays.through(x, y));
      if (agree(hit.depth, depth)) continue;
      bool edge = false;
      for (int k = 0; k < 9; ++k) {
        const auto near = rays.through(x + 1e-3 * (k % 3 - 1), y + 1e-3 * (k / 3 - 1));
        edge = edge || agree(hit.depth, depth_of(scene, near));
      }
      out.at_edges += edge;
      out.wrong += !edge;
    }
  }
  testing::Test::RecordProperty("pixels_on_boxes", static_cast<int>(out.on_boxes));
  testing::Test::RecordProperty("pixels_at_edges", static_cast<int>(out.at_edges));
  return out;
}

TEST(PictureProperty, DepthIsTheExactDistanceToBoxesAndGround) {
  const Comparison made_up = compare(support::random_city(5, 400, 400), 21, 100000);
  EXPECT_EQ(made_up.wrong, 0u) << "seed 21";
  EXPECT_LE(made_up.at_edges, 10u);
  EXPECT_GT(made_up.on_boxes, 10000u);
}

TEST(PictureProperty, DepthIsExactFarFromTheOrigin) {
  const geom::BoxMap map = support::random_city(6, 300, 300, Vec3(551000, 4182000, 0));
  const Comparison far = compare(map, 22, 20000);
  EXPECT_EQ(far.wrong, 0u) << "seed 22";
  EXPECT_LE(far.at_edges, 4u);
}

// The demo's city, or the real one where SKYWAY_REALDATA is set.
TEST(PictureProperty, DepthIsExactInACity) {
  const Comparison city = compare(support::load_city(support::city_file()), 23, 100000);
  EXPECT_EQ(city.wrong, 0u) << "seed 23";
  EXPECT_LE(city.at_edges, 10u);
  EXPECT_GT(city.on_boxes, 20000u);
}

TEST(PictureProperty, IdsNameTheBoxThatIsSeen) {
  const geom::BoxMap map = support::random_city(7, 100, 100);
  const render::PictureScene scene(map, {});
  const render::Shader shader(scene, render::box_colours(map), {}, false);
  Random random(24);
  std::size_t named = 0;
  for (int round = 0; round < 4; ++round) {
    const View view = random_view(random, scene, map.spec().bounds);
    const auto picture =
        render::take_pictures(scene, shader, std::span(&view, 1), {false, true, true, 1}, {})[0];
    for (int n = 0; n < 2000; ++n) {
      const int x = random.below(view.width);
      const int y = random.below(view.height);
      const std::size_t at = static_cast<std::size_t>(y * view.width + x);
      if (picture.id[at] == 0) continue;
      const Aabb& box = map.boxes()[picture.id[at] - 1];
      const auto ray = Rays(view).through(x, y);
      const Vec3 seen = ray.origin + double{picture.depth[at]} * ray.direction;
      EXPECT_LT(geom::distance(seen, box), 1e-3) << "seed 24, round " << round;
      ++named;
    }
  }
  EXPECT_GT(named, 500u);
}

TEST(Picture, TheSkyHasNoDepthAndNoId) {
  const geom::BoxMap map = support::random_city(7, 10, 50);
  const render::PictureScene scene(map, {});
  render::Pose pose;
  pose.position = {0, 0, 500};
  pose.attitude = Eigen::AngleAxisd(-1.5, Vec3::UnitY()).toRotationMatrix();  // the nose up
  const Block block = scene.cast(Rays(render::view_from({}, pose)), 320, 240);
  EXPECT_EQ(block[0].kind, Hit::Kind::sky);
  EXPECT_EQ(block[0].depth, 0);
}

TEST(Picture, TheSameForAnyNumberOfThreads) {
  const geom::BoxMap map = support::random_city(8, 300, 200);
  const render::PictureScene scene(map, {});
  render::Light light;
  light.shadows = true;
  const render::Shader shader(scene, render::box_colours(map), light, false);
  Random random(25);
  const View views[] = {random_view(random, scene, map.spec().bounds),
                        random_view(random, scene, map.spec().bounds)};
  const render::Wanted wanted{true, true, true, 2};
  const auto one = render::take_pictures(scene, shader, views, wanted, {1, {}});
  const auto seven = render::take_pictures(scene, shader, views, wanted, {7, {}});
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(one[i].colour, seven[i].colour);
    EXPECT_EQ(one[i].depth, seven[i].depth);
    EXPECT_EQ(one[i].id, seven[i].id);
  }
}

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

render::Picture small_picture() {
  render::Picture picture{3, 2, {}, {}, {}};
  picture.colour = {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {255, 255, 255}, {0, 0, 0}, {9, 8, 7}};
  picture.depth = {0, 1.25f, 2.5f, 655.349f, 655.36f, 3};
  picture.id = {0, 1, 256, 65536, 0xffffff, 70000};
  return picture;
}

// Read by libpng's simplified interface.
std::vector<std::uint8_t> decoded(const std::string& bytes) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_TRUE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()));
  image.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> out(PNG_IMAGE_SIZE(image));
  EXPECT_TRUE(png_image_finish_read(&image, nullptr, out.data(), 0, nullptr));
  return out;
}

TEST(Png, ColoursAndIdsComeBack) {
  const render::Picture picture = small_picture();
  const auto colour = decoded(render::colour_png(picture));
  const auto id = decoded(render::id_png(picture));
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ((render::Colour{colour[3 * i], colour[3 * i + 1], colour[3 * i + 2]}),
              picture.colour[i]);
    EXPECT_EQ(id[3 * i] + 256u * id[3 * i + 1] + 65536u * id[3 * i + 2], picture.id[i]);
  }
}

TEST(Png, DepthIsInUnitsAndZeroBeyondTheLast) {
  const std::string bytes = render::depth_png(small_picture(), 0.01);
  const auto* data = reinterpret_cast<png_const_bytep>(bytes.data());
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  struct Source {
    png_const_bytep at;
  } source{data};
  png_set_read_fn(png, &source, [](png_structp p, png_bytep to, std::size_t n) {
    auto* from = static_cast<Source*>(png_get_io_ptr(p));
    std::memcpy(to, from->at, n);
    from->at += n;
  });
  png_read_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
  EXPECT_EQ(png_get_bit_depth(png, info), 16);
  EXPECT_EQ(png_get_color_type(png, info), PNG_COLOR_TYPE_GRAY);
  std::vector<unsigned> values;
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) {
      const png_bytep p = png_get_rows(png, info)[y] + 2 * x;
      values.push_back(256u * p[0] + p[1]);
    }
  }
  png_destroy_read_struct(&png, &info, nullptr);
  EXPECT_EQ(values, (std::vector<unsigned>{0, 125, 250, 65535, 0, 300}));
}

TEST(Pfm, HoldsRowsFromTheBottom) {
  const std::string bytes = render::pfm(small_picture());
  const std::string header = "Pf\n3 2\n-1.0\n";
  ASSERT_EQ(bytes.substr(0, header.size()), header);
  ASSERT_EQ(bytes.size(), header.size() + 24);
  float first = 0;
  std::memcpy(&first, bytes.data() + header.size(), 4);
  EXPECT_EQ(first, 655.349f);
}

TEST(Y4m, HasTheLimitedRangeOfBt601) {
  EXPECT_EQ(render::y4m_header(640, 480, 29.97002997002997).substr(0, 30),
            "YUV4MPEG2 W640 H480 F30000:100");
  EXPECT_NE(render::y4m_header(4, 4, 10).find(" F10:1 "), std::string::npos);
  render::Picture white{3, 3, std::vector<render::Colour>(9, {255, 255, 255}), {}, {}};
  const std::string frame = render::y4m_frame(white);
  ASSERT_EQ(frame.size(), 6u + 9 + 4 + 4);
  EXPECT_EQ(static_cast<unsigned char>(frame[6]), 235);
  EXPECT_EQ(static_cast<unsigned char>(frame[15]), 128);
  EXPECT_EQ(static_cast<unsigned char>(frame[22]), 128);
  render::Picture red{2, 2, std::vector<render::Colour>(4, {255, 0, 0}), {}, {}};
  const std::string reds = render::y4m_frame(red);
  EXPECT_EQ(static_cast<unsigned char>(reds[6]), 81);  // BT.601: 81, 90, 240
  EXPECT_EQ(static_cast<unsigned char>(reds[10]), 90);
  EXPECT_EQ(static_cast<unsigned char>(reds[11]), 240);
}

TEST(CameraPoses, ComeBackBitForBit) {
  Random random(7);
  std::string text = std::string(render::kPosesHeader) + "\n";
  std::vector<View> views(20);
  for (std::size_t i = 0; i < views.size(); ++i) {
    for (int k = 0; k < 3; ++k) views[i].eye[k] = random.uniform(-1e3, 1e3);
    text += render::pose_row(views[i], i, 0.1 * static_cast<double>(i));
  }
  std::istringstream in(text);
  const auto poses = render::read_camera_poses(in, "poses");
  ASSERT_EQ(poses.size(), views.size());
  for (std::size_t i = 0; i < views.size(); ++i) {
    EXPECT_EQ(poses[i].eye, views[i].eye) << "seed 7, row " << i;
    EXPECT_EQ(poses[i].time, 0.1 * static_cast<double>(i));
  }
}

TEST(CameraPoses, RefusesOtherTables) {
  const std::string header = std::string(render::kPosesHeader) + "\n";
  for (const std::string& rows :
       {std::string(), std::string("0,0,1,2,3,1,0,0\n"), std::string("0,0,1,2,nan,1,0,0,0\n"),
        std::string("1,0,1,2,3,1,0,0,0\n"), std::string("0,0,1,2,3,1,0,0,0\n1,0,1,2,3,1,0,0,0\n"),
        std::string("0,0,1,2,3,1,0,0,0\n0,1,1,2,3,1,0,0,0\n")}) {
    std::istringstream in(header + rows);
    EXPECT_THROW(render::read_camera_poses(in, "poses"), geom::InputError) << rows;
  }
  std::istringstream other("frame,t_s\n0,0\n");
  EXPECT_THROW(render::read_camera_poses(other, "poses"), geom::InputError);
}

TEST(ReadPng, TakesWholePicturesOnly) {
  render::Picture picture{5, 3, std::vector<render::Colour>(15, {9, 8, 7}), {}, {}};
  for (std::size_t i = 0; i < 15; ++i) picture.colour[i].r = static_cast<std::uint8_t>(17 * i);
  const std::string png = render::colour_png(picture);
  const render::Pixels read = render::read_png(png, "f.png");
  EXPECT_EQ(read.width, 5);
  EXPECT_EQ(read.height, 3);
  ASSERT_EQ(read.rgb.size(), 45u);
  EXPECT_EQ(std::memcmp(read.rgb.data(), picture.colour.data(), 45), 0);
  for (std::size_t bytes = 0; bytes + 16 < png.size(); ++bytes) {  // all but the checksum and IEND
    EXPECT_THROW(render::read_png(png.substr(0, bytes), "f.png"), geom::InputError) << bytes;
  }
}

TEST(FrameOutput, NumbersNames) {
  EXPECT_EQ(render::numbered("a-%05d.png", 12), "a-00012.png");
  EXPECT_EQ(render::numbered("a%d", 7), "a7");
  EXPECT_EQ(render::numbered("%s.png", 7), "%s.png");
  EXPECT_THROW(render::FrameOutput("%n.png", 2, false), cli::UsageError);
  EXPECT_NO_THROW(render::FrameOutput("one.png", 1, false));
}

}  // namespace
