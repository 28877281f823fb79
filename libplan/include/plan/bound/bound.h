#pragma once

// A proved lower bound on the length of every path between two places.
//
// Example:
//   plan::Bounder bounder(scene);
//   const plan::LengthBound bound = bounder.ask({1, 1, 1}, {9, 1, 1}, geom::length(path));
//   assert(bound.closed);  // no path is more than 1 % shorter than this one
//   assert(bound.bound <= geom::length(path) && bound.bound > 0.98 * geom::length(path));
//
// A shortest path that may touch obstacles bends only on convex edges of the union of the grown
// boxes (docs/bound.md). These edges are cut into parts, and every path follows a chain of parts.
// Lines over the parts lie below the lengths of all chains that reach them, so they give a bound.
// Parts that no path shorter than wanted can use are dropped, and the others are halved, until the
// bound is near enough. If the chain with the least label, pulled taut, is a path that is shorter
// than the one known, the search goes on with its length.

#include <cstddef>
#include <memory>
#include <optional>

#include "geom/collision/collision.h"
#include "geom/shape/polyline.h"
#include "plan/bound/length_proof.h"

namespace plan {

using geom::Vec3;

struct BoundOptions {
  double gap = 1e-2;              // the bound wanted is length / (1 + gap); > 0
  std::size_t most = 60'000'000;  // steps: pairs of parts that are checked
  bool keep_proof = false;        // whether to give the reasons for the bound
};

struct LengthBound {
  // Metres: no path of the free space between the two places is shorter. At least a hair less than
  // the straight line.
  double bound = 0;
  bool closed = false;  // whether it is within the gap (of the path below, if there is one)
  // A free path that is shorter than the given length, if the search came upon one; else empty.
  geom::Polyline path;
  std::size_t steps = 0;  // as of BoundOptions
  std::size_t levels = 0;
  std::optional<LengthProof> proof;  // where it was to be kept
};

// May be asked from several threads at once; the scene must outlive it. The first question costs
// some microseconds for each box of the map. On a map of more than 20,000 boxes each question costs
// that for the boxes that a path shorter than the known one may meet, and where these are more than
// 50,000 the bound is the straight line; but the whole map is looked at where a proof is to be
// kept. If free_bounds() is flat along an axis, the bound is the straight line.
class Bounder {
 public:
  explicit Bounder(const geom::CollisionScene& scene);
  ~Bounder();

  // A bound for paths between two places, where one path is known to have `length` metres.
  LengthBound ask(const Vec3& from, const Vec3& to, double length,
                  const BoundOptions& options = {});

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace plan
