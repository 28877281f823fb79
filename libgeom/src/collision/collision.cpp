#include "geom/collision/collision.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geom/base/parallel.h"
#include "geom/base/precondition.h"
#include "groups.h"

// The queries that are made of the scene's own.

namespace geom {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kBatch = 256;  // segments of one task
constexpr double kStretch = 20;      // metres of a sweep that are looked around at once
constexpr double kMostStretches = 1e5;

// The bits of a number of 16 bits, with one between each two.
std::uint32_t spread(std::uint32_t x) {
  x = (x | x << 8) & 0x00ff00ff;
  x = (x | x << 4) & 0x0f0f0f0f;
  x = (x | x << 2) & 0x33333333;
  return (x | x << 1) & 0x55555555;
}

// The segments from neighbour to neighbour, in plan (Morton 1966): groups of tiles that were given
// up meanwhile are then not built for each segment anew.
std::vector<std::size_t> by_place(std::span<const std::pair<Vec3, Vec3>> segments,
                                  const Aabb& reach) {
  const Eigen::Array2d low = reach.min.head<2>();
  const Eigen::Array2d size = (reach.max - reach.min).head<2>().cwiseMax(1.0);
  std::vector<std::pair<std::uint32_t, std::size_t>> keys(segments.size());
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto& [a, b] = segments[i];
    require_points("segment", a, b);
    const Eigen::Array2d share = ((a.head<2>().array() - low) / size).max(0.0).min(1.0);
    const Eigen::Array2<std::uint32_t> cell = (share * 65535).cast<std::uint32_t>();
    keys[i] = {spread(cell.x()) | spread(cell.y()) << 1, i};
  }
  std::sort(keys.begin(), keys.end());
  std::vector<std::size_t> order(segments.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = keys[i].second;
  return order;
}

Aabb around(const Vec3& a, const Vec3& b, const Vec3& pad) {
  return {a.cwiseMin(b) - pad, a.cwiseMax(b) + pad};
}

}  // namespace

std::vector<std::uint8_t> CollisionScene::hits(std::span<const std::pair<Vec3, Vec3>> segments,
                                               const Execution& run) const {
  std::vector<std::uint8_t> out(segments.size());
  std::vector<std::size_t> order;
  if (!impl_->keeps_all) order = by_place(segments, impl_->reach);
  parallel_for((segments.size() + kBatch - 1) / kBatch, run, [&](std::size_t batch) {
    const std::size_t end = std::min(segments.size(), (batch + 1) * kBatch);
    for (std::size_t k = batch * kBatch; k < end; ++k) {
      const std::size_t i = order.empty() ? k : order[k];
      out[i] = hits(segments[i].first, segments[i].second);
    }
  });
  return out;
}

bool CollisionScene::sweep_hits(const Vec3& a, const Vec3& b, const Vec3& half) const {
  require_points("segment", a, b);
  for (const double size : half) require_length("swept box", size, kLargestCoordinate);
  // Whatever the swept box meets, once grown by the vehicle instead, meets a stretch grown by the
  // difference; the whole segment decides.
  const Vec3 pad = (half - this->half()).cwiseMax(0) + Vec3::Constant(1e-6);
  const double parts = std::ceil(std::clamp((b - a).norm() / kStretch, 1.0, kMostStretches));
  for (double k = 0; k < parts; ++k) {
    const Vec3 from = a + (b - a) * (k / parts);
    const Vec3 to = k + 1 == parts ? b : Vec3(a + (b - a) * ((k + 1) / parts));
    for (const std::size_t i : boxes_meeting(around(from, to, pad))) {
      if (segment_hits(a, b, grow(map().box(i), half))) return true;
    }
  }
  return false;
}

std::vector<CollisionScene::Separated> CollisionScene::separating_planes(const Vec3& a,
                                                                         const Vec3& b,
                                                                         double reach) const {
  require_points("segment", a, b);
  require_length("reach", reach, kInfinity);
  std::vector<Separated> out;
  for (const std::size_t i : boxes_meeting(around(a, b, Vec3::Constant(reach)))) {
    const Aabb box = grown(i);
    if (distance(a, b, box) <= reach) out.push_back({i, separation(a, b, box)});
  }
  std::stable_sort(out.begin(), out.end(), [](const Separated& x, const Separated& y) {
    return x.separation.gap < y.separation.gap;
  });
  return out;
}

std::optional<EmptyBox> CollisionScene::empty_box(const Vec3& a, const Vec3& b,
                                                  double reach) const {
  require_length("reach", reach, kInfinity);
  if (!free_bounds() || !inside_bounds(a) || !inside_bounds(b)) return std::nullopt;
  Aabb limits = around(a, b, Vec3::Constant(reach));
  limits = {limits.min.cwiseMax(free_bounds()->min), limits.max.cwiseMin(free_bounds()->max)};
  std::vector<Aabb> obstacles;
  for (const std::size_t i : boxes_meeting(limits)) obstacles.push_back(grown(i));
  return geom::empty_box({a.cwiseMin(b), a.cwiseMax(b)}, limits, obstacles);
}

}  // namespace geom
