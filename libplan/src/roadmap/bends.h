#pragma once

// Bends around boxes, and which of them are joined: what building, patching and searching a roadmap
// share.

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "path/short_ways.h"
#include "plan/roadmap/roadmap.h"

namespace plan {

// The direction across the box edge of a bend, with outward signs: the box is where both are
// negative.
struct Across {
  double x;
  double y;

  // Boxes in a row are flush to the last digit only: what misses by less than a millimetre passes.
  static constexpr double kFlush = 1e-3;
  bool tangent() const { return (x * y <= 0) | (std::min(std::abs(x), std::abs(y)) < kFlush); }
  bool second_side() const { return x > y; }
  double ratio() const {
    const double sum = std::abs(x) + std::abs(y);
    return sum > 0 ? std::abs(y) / sum : 0;
  }
};

inline Across across(const Bend& bend, const Vec3& direction) {
  return {direction[(bend.axis + 1) % 3] * bend.outward[0],
          direction[(bend.axis + 2) % 3] * bend.outward[1]};
}

// Adds the bends around a grown box, in their order; with a `square`, of infinite height, those
// that stand in it and perhaps some near it; with `ways`, those that these hold.
void add_bends(const geom::CollisionScene& scene, const geom::Aabb& box, double part,
               const std::optional<geom::Aabb>& square, std::vector<Bend>& out,
               const ShortWays* ways = nullptr);

// The bends that the ways hold, around all boxes; nothing where these are more than `most`.
std::optional<std::vector<Bend>> bends_within(const geom::CollisionScene& scene, double part,
                                              const ShortWays& ways, std::size_t most);

// Whether two bends are within reach and the line between them is tangent to both boxes.
inline bool aligned(const Bend& a, const Bend& b, double reach) {
  const Vec3 d = b.position - a.position;
  return d.squaredNorm() <= reach * reach && across(a, d).tangent() && across(b, -d).tangent();
}

// aligned(), and nothing is in between: there is an edge.
inline bool linked(const geom::CollisionScene& scene, const Bend& a, const Bend& b, double reach) {
  return aligned(a, b, reach) && !scene.hits(a.position, b.position);
}

// Where an edge stands among those of its bend: see Roadmap.
struct EdgeKey {
  bool second;
  double ratio;
  std::uint32_t to;

  friend bool operator<(const EdgeKey& a, const EdgeKey& b);
};

EdgeKey edge_key(std::span<const Bend> bends, std::size_t from, std::uint32_t to);

}  // namespace plan
