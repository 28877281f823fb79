#include "traj/proof/clearance.h"

#include <cassert>

#include "least_clearance.h"

namespace traj {
namespace {

// The part of the curve before u (0 to 1), and the part after it.
std::pair<Points<kPoints>, Points<kPoints>> cut(Points<kPoints> q, double u) {
  Points<kPoints> before;
  Points<kPoints> after;
  for (std::size_t m = 0; m < kPoints; ++m) {
    before[m] = q[0];
    after[kPoints - 1 - m] = q[kPoints - 1 - m];
    for (std::size_t i = 0; i + 1 + m < kPoints; ++i) q[i] += u * (q[i + 1] - q[i]);
  }
  return {before, after};
}

void append_spans(const geom::CollisionScene& scene, Piece piece, double step,
                  std::vector<ClearanceSpan>& out) {
  const double length = piece.end - piece.begin;
  const double count = std::max(1.0, std::ceil(length / step));
  const double first = piece.begin;
  for (double k = 1; k <= count; ++k) {
    Piece part = piece;
    if (k < count) {
      std::tie(part.q, piece.q) = cut(piece.q, 1 / (count - k + 1));
      part.end = piece.begin = first + length * (k / count);
    }
    out.push_back({part.begin, part.end, least_clearance(scene, {part})->value});
  }
}

}  // namespace

std::optional<Extreme> least_clearance(const geom::CollisionScene& scene,
                                       const std::vector<Piece>& pieces) {
  if (scene.map().size() == 0) return std::nullopt;
  Largest best;
  // The distance moves by at most 1 per metre; what is too far to matter is not looked up, and
  // below 0 there is nothing to look for.
  const auto nearness = [&](const Piece& piece, const Vec3& middle) {
    if (best.value >= 0) return Estimate{0, 0};
    const double r = radius_around(piece.q, middle);
    const double beside = piece.stray.norm();
    const auto near = scene.nearest(middle, r + beside - best.value);
    const double value = near ? beside - near->distance : best.value - r;
    return Estimate{value, value + r};
  };
  search_largest(pieces, 1e-3, nearness, best);
  return Extreme{std::max(0.0, -best.value), best.time};
}

std::vector<ClearanceSpan> clearance_profile(const geom::CollisionScene& scene,
                                             const Trajectory& trajectory, double step) {
  assert(step > 0);
  std::vector<ClearanceSpan> out;
  if (scene.map().size() == 0) return out;
  for (const Piece& piece : pieces_of(trajectory)) append_spans(scene, piece, step, out);
  return out;
}

std::vector<ClearanceSpan> clearance_profile(const geom::CollisionScene& scene,
                                             std::span<const Vec3> path, double step) {
  assert(step > 0);
  std::vector<ClearanceSpan> out;
  if (scene.map().size() == 0) return out;
  double along = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double length = (path[i] - path[i - 1]).norm();
    append_spans(scene, straight_piece(path[i - 1], path[i], along, along + length), step, out);
    along += length;
  }
  return out;
}

std::vector<ClearanceSpan> clearance_profile(const geom::CollisionScene& scene,
                                             std::span<const Vec3> path,
                                             std::span<const double> times) {
  assert(path.size() == times.size());
  std::vector<ClearanceSpan> out;
  if (scene.map().size() == 0) return out;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Piece leg = straight_piece(path[i - 1], path[i], times[i - 1], times[i]);
    out.push_back({leg.begin, leg.end, least_clearance(scene, {leg})->value});
  }
  return out;
}

}  // namespace traj
