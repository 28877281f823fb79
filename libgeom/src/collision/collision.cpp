#include "geom/collision/collision.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geom/base/parallel.h"
#include "geom/base/precondition.h"

// The queries that are made of the scene's own.

namespace geom {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kBatch = 256;  // segments of one task
constexpr double kStretch = 20;      // metres of a sweep that are looked around at once
constexpr double kMostStretches = 1e5;

Aabb around(const Vec3& a, const Vec3& b, const Vec3& pad) {
  return {a.cwiseMin(b) - pad, a.cwiseMax(b) + pad};
}

}  // namespace

std::vector<std::uint8_t> CollisionScene::hits(std::span<const std::pair<Vec3, Vec3>> segments,
                                               const Execution& run) const {
  std::vector<std::uint8_t> out(segments.size());
  parallel_for((segments.size() + kBatch - 1) / kBatch, run, [&](std::size_t batch) {
    const std::size_t end = std::min(segments.size(), (batch + 1) * kBatch);
    for (std::size_t i = batch * kBatch; i < end; ++i) {
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
