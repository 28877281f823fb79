#include "plan/roadmap/roadmap_estimate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "found_edges.h"

namespace plan {
namespace {

constexpr std::size_t kSamples = 8;
constexpr std::uint64_t kBoxes = 400;  // of a sample, at least

// Runs of squares, as far from each other as there is room.
std::vector<SquareRun> samples_of(const std::vector<SquareShare>& all, std::uint64_t boxes) {
  std::vector<SquareRun> out;
  std::uint64_t before = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::uint64_t next = (2 * out.size() + 1) * boxes / (2 * kSamples);
    if (before >= next && out.size() < kSamples) {
      SquareRun run{i, i};
      std::uint64_t taken = 0;
      for (; run.end < all.size() && taken < kBoxes; ++run.end) taken += all[run.end].boxes;
      out.push_back(run);
    }
    before += all[i].boxes;
  }
  return out;
}

// Of one run of squares, as if all others were built, too.
RoadmapEstimate taken(const geom::CollisionScene& scene, const RoadmapSpec& spec,
                      const SquaresAround& squares, const std::function<double()>& clock) {
  RoadmapEstimate out;
  const double begin = clock();
  const OwnBends own = own_bends(scene, spec, squares, {});
  const double middle = clock();
  double within = 0;
  double across = 0;
  for (const auto& edges : found_edges(scene, own, spec.reach, {})) {
    for (const std::uint32_t j : edges) ++(own.is_own(j) ? within : across);
  }
  const double end = clock();
  out.bends = own.end - own.first;
  out.edges = within + across / 2;  // those across are found from both sides here
  out.seconds = (middle - begin) * static_cast<double>(squares.own.end - squares.own.begin) /
                static_cast<double>(squares.codes.size());
  if (within + across > 0) out.seconds += (end - middle) * out.edges / (within + across);
  return out;
}

}  // namespace

RoadmapEstimate estimate_roadmap(const geom::CollisionScene& scene, const RoadmapSpec& spec,
                                 const std::function<double()>& clock) {
  constexpr double kBytesOfBend = 34;
  constexpr double kBytesOfEdge = 8;
  const std::vector<SquareShare> all = squares_of(scene, spec);
  std::uint64_t boxes = 0;
  for (const SquareShare& share : all) boxes += share.boxes;
  RoadmapEstimate sum;
  std::uint64_t sampled = 0;
  for (const SquareRun& run : samples_of(all, boxes)) {
    const RoadmapEstimate one = taken(scene, spec, around(all, run, spec.reach), clock);
    sum.bends += one.bends;
    sum.edges += one.edges;
    sum.seconds += one.seconds;
    for (std::size_t i = run.begin; i < run.end; ++i) sampled += all[i].boxes;
  }
  if (sampled == 0) return {};
  const double times = static_cast<double>(boxes) / static_cast<double>(sampled);
  sum.bends *= times;
  sum.edges *= times;
  sum.seconds *= times;
  sum.bytes = sum.bends * kBytesOfBend + sum.edges * kBytesOfEdge;
  return sum;
}

RoadmapEstimate rough_estimate(std::size_t boxes, double reach, const geom::Aabb& area) {
  constexpr double kPair = 40e-9;  // seconds
  RoadmapEstimate out;
  out.bends = 9 * static_cast<double>(boxes);
  out.edges = 0.5 * out.bends * std::min(reach, out.bends);
  out.bytes = out.bends * 34 + out.edges * 8;
  const geom::Vec3 size = area.max - area.min;
  const double share = std::min(1.0, 3 * reach / std::max(size.x(), 1.0)) *
                       std::min(1.0, 3 * reach / std::max(size.y(), 1.0));
  out.seconds = 0.5 * out.bends * out.bends * share * kPair;
  return out;
}

std::string in_words(const RoadmapEstimate& estimate) {
  const double minutes = estimate.seconds / 60;
  return fmt::format(
      "about {:.1f} million bends, {:.0f} million edges and {:.1f} GB, and take about {}",
      estimate.bends / 1e6, estimate.edges / 1e6, estimate.bytes / 1e9,
      minutes < 2 ? fmt::format("{:.0f} seconds of a core", std::ceil(estimate.seconds))
                  : fmt::format("{:.0f} minutes of a core", std::ceil(minutes)));
}

}  // namespace plan
