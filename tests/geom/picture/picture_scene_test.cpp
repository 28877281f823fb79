// Pictures against slow ones in double precision.

#include "geom/picture/picture_scene.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <vector>

#include "geom/picture/camera.h"
#include "geom/picture/take.h"
#include "support/city.h"
#include "support/random_city.h"

namespace {

using geom::Aabb;
using geom::Axes;
using geom::Vec3;
using geom::picture::Block;
using geom::picture::Hit;
using geom::picture::Rays;
using geom::picture::View;
using support::Random;

// Where the ray enters the first box, by slabs in double; nothing where it meets none.
struct Entry {
  double depth = std::numeric_limits<double>::infinity();
  std::size_t box = 0;
};
Entry first_box(const geom::picture::Ray& ray, std::span<const Aabb> boxes) {
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
double depth_of(const geom::picture::PictureScene& scene, const geom::picture::Ray& ray) {
  double depth = first_box(ray, scene.boxes()).depth;
  const double ground = (scene.ground() - ray.origin.z()) / ray.direction.z();
  if (ground > 0) depth = std::min(depth, ground);
  return std::isfinite(depth) ? depth : 0;
}

bool agree(double a, double b) { return std::abs(a - b) <= 1e-4 * std::max(a, b); }

View random_view(Random& random, const geom::picture::PictureScene& scene, const Aabb& bounds) {
  for (;;) {
    geom::picture::Pose pose;
    for (int i = 0; i < 3; ++i) pose.position[i] = random.uniform(bounds.min[i], bounds.max[i]);
    const auto holds = [&](const Aabb& box) { return geom::distance(pose.position, box) < 0.5; };
    if (std::any_of(scene.boxes().begin(), scene.boxes().end(), holds)) continue;
    pose.attitude = Eigen::Quaterniond(random.uniform(-1, 1), random.uniform(-0.2, 0.2),
                                       random.uniform(-0.2, 0.2), random.uniform(-1, 1))
                        .normalized()
                        .toRotationMatrix();
    return geom::picture::view_from({}, pose);
  }
}

struct Comparison {
  std::size_t pixels = 0;
  std::size_t on_boxes = 0;
  std::size_t at_edges = 0;  // where a thousandth of a pixel decides
  std::size_t wrong = 0;
};

Comparison compare(const geom::BoxMap& map, std::uint64_t seed, std::size_t pixels) {
  const geom::picture::PictureScene scene(map, {});
  const Axes axes = map.spec().frame.axes;
  const Aabb bounds = geom::to_enu(axes, map.spec().bounds);
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

// Frames of depth alone take another way through the code. Tubes, the sky and the ground are seen,
// and blocks that reach over the edge of the picture.
TEST(PictureProperty, DepthAloneIsTheSameToTheLastBit) {
  const geom::BoxMap map = support::random_city(7, 200, 200, {3000, -500, 0});
  geom::picture::Tubes tubes;
  Random random(25);
  for (std::uint32_t k = 0; k < 40; ++k) {
    tubes.points.push_back({3000 + random.uniform(-100, 100), -500 + random.uniform(-100, 100),
                            random.uniform(10, 80)});
    if (k > 0) tubes.edges.push_back({k - 1, k});
  }
  const geom::picture::PictureScene scene(map, std::span(&tubes, 1));
  const geom::picture::Shader shader(scene, geom::picture::look_of(map), {}, false);
  std::vector<View> views;
  for (int round = 0; round < 12; ++round) {
    views.push_back(random_view(random, scene, map.spec().bounds));
  }
  views.push_back(geom::picture::plan_view(map.spec().bounds, 638, 479));
  views.push_back(geom::picture::overview(map.spec().bounds, 638, 479, {}));
  std::set<Hit::Kind> seen;
  for (View& view : views) {
    view.width = 638;
    view.height = 479;
    const auto alone = geom::picture::take_pictures(scene, shader, std::span(&view, 1),
                                                    {false, true, false, 1}, {})[0];
    const Rays rays(view);
    for (int y = 0; y < view.height; y += geom::picture::kBlock) {
      for (int x = 0; x < view.width; x += geom::picture::kBlock) {
        const Block block = scene.cast(rays, x, y);
        for (int i = 0; i < geom::picture::kBlock * geom::picture::kBlock; ++i) {
          const int px = x + i % geom::picture::kBlock;
          const int py = y + i / geom::picture::kBlock;
          const Hit& hit = block[static_cast<std::size_t>(i)];
          seen.insert(hit.kind);
          if (px >= view.width || py >= view.height) continue;
          ASSERT_EQ(std::bit_cast<std::uint32_t>(
                        alone.depth[static_cast<std::size_t>(py * view.width + px)]),
                    std::bit_cast<std::uint32_t>(hit.depth))
              << "pixel " << px << ", " << py;
        }
      }
    }
  }
  EXPECT_EQ(seen.size(), 4u);
}

TEST(PictureProperty, DepthOfAMapWithoutBoxesIsThatOfTheGround) {
  const geom::BoxMap map = support::random_city(1, 0, 50);
  const geom::picture::PictureScene scene(map, {});
  const View view = geom::picture::overview(map.spec().bounds, 64, 48, {});
  const auto depths = scene.depths(Rays(view), 32, 24);
  const Block block = scene.cast(Rays(view), 32, 24);
  for (std::size_t i = 0; i < depths.size(); ++i) {
    EXPECT_EQ(block[i].kind, Hit::Kind::ground);
    EXPECT_EQ(depths[i], block[i].depth);
  }
}

TEST(PictureProperty, IdsNameTheBoxThatIsSeen) {
  const geom::BoxMap map = support::random_city(7, 100, 100);
  const geom::picture::PictureScene scene(map, {});
  const geom::picture::Shader shader(scene, geom::picture::look_of(map), {}, false);
  Random random(24);
  std::size_t named = 0;
  for (int round = 0; round < 4; ++round) {
    const View view = random_view(random, scene, map.spec().bounds);
    const auto picture = geom::picture::take_pictures(scene, shader, std::span(&view, 1),
                                                      {false, true, true, 1}, {})[0];
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
  const geom::picture::PictureScene scene(map, {});
  geom::picture::Pose pose;
  pose.position = {0, 0, 500};
  pose.attitude = Eigen::AngleAxisd(-1.5, Vec3::UnitY()).toRotationMatrix();  // the nose up
  const Block block = scene.cast(Rays(geom::picture::view_from({}, pose)), 320, 240);
  EXPECT_EQ(block[0].kind, Hit::Kind::sky);
  EXPECT_EQ(block[0].depth, 0);
}

TEST(Picture, TheSameForAnyNumberOfThreads) {
  const geom::BoxMap map = support::random_city(8, 300, 200);
  const geom::picture::PictureScene scene(map, {});
  geom::picture::Light light;
  light.shadows = true;
  const geom::picture::Shader shader(scene, geom::picture::look_of(map), light, false);
  Random random(25);
  const View views[] = {random_view(random, scene, map.spec().bounds),
                        random_view(random, scene, map.spec().bounds)};
  const geom::picture::Wanted wanted{true, true, true, 2};
  const auto one = geom::picture::take_pictures(scene, shader, views, wanted, {1, {}});
  const auto seven = geom::picture::take_pictures(scene, shader, views, wanted, {7, {}});
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(one[i].colour, seven[i].colour);
    EXPECT_EQ(one[i].depth, seven[i].depth);
    EXPECT_EQ(one[i].id, seven[i].id);
  }
}

}  // namespace
