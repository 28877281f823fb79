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

double parts_of(double length, double step) { return std::max(1.0, std::ceil(length / step)); }

// A box that is there for a time counts as always there.
ClearanceSpan span_of(const geom::CollisionScene& scene, const Piece& part) {
  return {part.begin, part.end, least_clearance(scene, BoxTimes(), {part})->value};
}
ClearanceSpan span_of(const geom::CollisionScene& scene, const Leg& part) {
  return {part.begin, part.end, least_clearance(scene, {part})->value};
}

void append_spans(const geom::CollisionScene& scene, Piece piece, double step,
                  std::vector<ClearanceSpan>& out) {
  const double length = piece.end - piece.begin;
  const double count = parts_of(length, step);
  const double first = piece.begin;
  for (double k = 1; k <= count; ++k) {
    Piece part = piece;
    if (k < count) {
      std::tie(part.q, piece.q) = cut(piece.q, 1 / (count - k + 1));
      part.end = piece.begin = first + length * (k / count);
    }
    out.push_back(span_of(scene, part));
  }
}

void append_spans(const geom::CollisionScene& scene, const Leg& leg, double step,
                  std::vector<ClearanceSpan>& out) {
  const double length = leg.end - leg.begin;
  const double count = parts_of(length, step);
  Leg part = leg;
  for (double k = 1; k <= count; ++k) {
    part.to = k < count ? Vec3(leg.from + (leg.to - leg.from) * (k / count)) : leg.to;
    part.end = k < count ? leg.begin + length * (k / count) : leg.end;
    out.push_back(span_of(scene, part));
    part.from = part.to;
    part.begin = part.end;
  }
}

}  // namespace

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
    append_spans(scene, Leg{path[i - 1], path[i], along, along + length}, step, out);
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
    out.push_back(span_of(scene, Leg{path[i - 1], path[i], times[i - 1], times[i]}));
  }
  return out;
}

}  // namespace traj
