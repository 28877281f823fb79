// Frames of 640 x 480, colour and depth, from random places in the city's streets.

#include <benchmark/benchmark.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "render/camera/camera.h"
#include "render/image/image_file.h"
#include "render/scene/take.h"
#include "support/city.h"
#include "support/random_city.h"

namespace {

constexpr std::size_t kViews = 64;
constexpr std::size_t kBatch = 8;

const geom::BoxMap& city() {
  static const geom::BoxMap map = support::load_city(support::city_file());
  return map;
}

const render::PictureScene& scene() {
  static const render::PictureScene one(city(), {});
  return one;
}

const render::Shader& shader() {
  static const render::Shader one(scene(), render::look_of(city()), {}, false);
  return one;
}

// Level or nearly so, 5 to 60 m up, not inside a box.
std::vector<render::View> views() {
  support::Random random(1);
  const auto [low, high] = geom::to_enu(city().spec().frame.axes, city().spec().bounds);
  std::vector<render::View> out;
  while (out.size() < kViews) {
    render::Pose pose;
    pose.position = {random.uniform(low.x(), high.x()), random.uniform(low.y(), high.y()),
                     random.uniform(5, 60)};
    pose.attitude = (Eigen::AngleAxisd(random.uniform(-3.1, 3.1), geom::Vec3::UnitZ()) *
                     Eigen::AngleAxisd(random.uniform(-0.2, 0.3), geom::Vec3::UnitY()))
                        .toRotationMatrix();
    const auto near = [&](const geom::Aabb& box) { return distance(pose.position, box) < 2; };
    if (std::any_of(scene().boxes().begin(), scene().boxes().end(), near)) continue;
    out.push_back(render::view_from({}, pose));
  }
  return out;
}

void frames(benchmark::State& state, const render::Wanted& wanted, bool video) {
  const auto all = views();
  const geom::Execution run{static_cast<unsigned>(state.range(0)), {}};
  shader();
  std::size_t at = 0;
  for (auto _ : state) {
    const std::span<const render::View> batch(all.data() + at, kBatch);
    const auto pictures = render::take_pictures(scene(), shader(), batch, wanted, run);
    at = (at + kBatch) % kViews;
    if (!video) continue;
    for (const auto& picture : pictures) benchmark::DoNotOptimize(render::y4m_frame(picture));
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * kBatch));
}

void colour_and_depth(benchmark::State& state) { frames(state, {true, true, false, 1}, false); }
void depth_alone(benchmark::State& state) { frames(state, {false, true, false, 1}, false); }
void colour_as_y4m(benchmark::State& state) { frames(state, {true, false, false, 1}, true); }

BENCHMARK(colour_and_depth)->Arg(1)->Arg(2)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(depth_alone)->Arg(1)->Arg(2)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(colour_as_y4m)->Arg(2)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
