// Frames of 640 x 480, colour and depth, from random places in the city's streets; depth also by
// Embree's packets of sixteen rays alone.

#include <benchmark/benchmark.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "geom/picture/camera.h"
#include "geom/picture/image_file.h"
#include "geom/picture/take.h"
#include "packet_peer.h"
#include "support/city.h"
#include "support/random_city.h"

namespace {

constexpr std::size_t kViews = 64;
constexpr std::size_t kBatch = 8;

const geom::BoxMap& city() {
  static const geom::BoxMap map = support::load_city(support::city_file());
  return map;
}

const geom::picture::PictureScene& scene() {
  static const geom::picture::PictureScene one(city(), {});
  return one;
}

const geom::picture::Shader& shader() {
  static const geom::picture::Shader one(scene(), geom::picture::look_of(city()), {}, false);
  return one;
}

// Level or nearly so, 5 to 60 m up, not inside a box.
std::vector<geom::picture::View> views() {
  support::Random random(1);
  const auto [low, high] = geom::to_enu(city().spec().frame.axes, city().spec().bounds);
  std::vector<geom::picture::View> out;
  while (out.size() < kViews) {
    geom::picture::Pose pose;
    pose.position = {random.uniform(low.x(), high.x()), random.uniform(low.y(), high.y()),
                     random.uniform(5, 60)};
    pose.attitude = (Eigen::AngleAxisd(random.uniform(-3.1, 3.1), geom::Vec3::UnitZ()) *
                     Eigen::AngleAxisd(random.uniform(-0.2, 0.3), geom::Vec3::UnitY()))
                        .toRotationMatrix();
    const auto near = [&](const geom::Aabb& box) { return distance(pose.position, box) < 2; };
    if (std::any_of(scene().boxes().begin(), scene().boxes().end(), near)) continue;
    out.push_back(geom::picture::view_from({}, pose));
  }
  return out;
}

void frames(benchmark::State& state, const geom::picture::Wanted& wanted, bool video) {
  const auto all = views();
  const geom::Execution run{static_cast<unsigned>(state.range(0)), {}};
  shader();
  std::size_t at = 0;
  for (auto _ : state) {
    const std::span<const geom::picture::View> batch(all.data() + at, kBatch);
    const auto pictures = geom::picture::take_pictures(scene(), shader(), batch, wanted, run);
    at = (at + kBatch) % kViews;
    if (!video) continue;
    for (const auto& picture : pictures)
      benchmark::DoNotOptimize(geom::picture::y4m_frame(picture));
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * kBatch));
}

void colour_and_depth(benchmark::State& state) { frames(state, {true, true, false, 1}, false); }
void depth_alone(benchmark::State& state) { frames(state, {false, true, false, 1}, false); }
void colour_as_y4m(benchmark::State& state) { frames(state, {true, false, false, 1}, true); }

void depth_by_packets_alone(benchmark::State& state) {
  static const bench::PacketPeer peer(scene().boxes(), scene().middle(), scene().ground());
  const auto all = views();
  std::size_t at = 0;
  for (auto _ : state) {
    std::vector<std::vector<float>> pictures;
    for (std::size_t k = 0; k < kBatch; ++k) pictures.push_back(peer.depths(all[at + k]));
    benchmark::DoNotOptimize(pictures);
    at = (at + kBatch) % kViews;
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * kBatch));
}

BENCHMARK(colour_and_depth)->Arg(1)->Arg(2)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(depth_alone)->Arg(1)->Arg(2)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(depth_by_packets_alone)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(colour_as_y4m)->Arg(2)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
