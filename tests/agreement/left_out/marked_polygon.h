#pragma once

// Polygons whose points are marks, and whether the boxes of a model hold these.

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "geom/model/model_polygons.h"
#include "support/left_out.h"

namespace left_out {

using geom::Vec3;
using support::chance;
using support::MarkedFile;
using support::Outcome;
using support::Random;

using Polygon3 = std::vector<Vec3>;

// Convex as it is seen along one axis, and bent along it or not.
inline Polygon3 random_polygon(Random& random, int most_corners) {
  const Vec3 middle = support::random_place(random);
  const int n = 3 + random.below(most_corners - 2);
  const int axis = random.below(3);
  const double bend = chance(random, 2) ? 0.6 : 0;
  Polygon3 out;
  for (int i = 0; i < n; ++i) {
    const double angle = 6.283185307179586 * (i + random.uniform(0, 0.5)) / n;
    Vec3 p = Vec3::Zero();
    p[(axis + 1) % 3] = 2 * std::cos(angle);
    p[(axis + 2) % 3] = 2 * std::sin(angle);
    p[axis] = random.uniform(-bend, bend);
    out.push_back(middle + p);
  }
  return out;
}

// Points on triangles of any three corners: of a convex polygon, some way to cut it has each.
inline void mark(Random& random, const Polygon3& polygon, MarkedFile& out) {
  const int n = static_cast<int>(polygon.size());
  for (int k = 0; k < 6; ++k) {
    double share[3] = {random.uniform(0.01, 1), random.uniform(0.01, 1), random.uniform(0.01, 1)};
    const double sum = share[0] + share[1] + share[2];
    Vec3 p = Vec3::Zero();
    const int first = random.below(n);
    const int second = (first + 1 + random.below(n - 2)) % n;
    const int steps = (second - first + n) % n;
    const int third = (second + 1 + random.below(n - 1 - steps)) % n;
    for (const auto& [i, s] : {std::pair{first, share[0]}, {second, share[1]}, {third, share[2]}}) {
      p += s / sum * polygon[static_cast<std::size_t>(i)];
    }
    out.marks.push_back(p);
  }
}

// What the tools make of a model: its boxes, larger by its blur and by 1 mm for the rounding of
// single precision.
inline Outcome outcome(const geom::Model& model, const MarkedFile& file) {
  if (!model.skipped.empty()) return Outcome::told;
  if (model.mesh.triangles.empty()) return Outcome::told;  // the tools refuse it
  geom::TriangleCoverOptions options;
  options.slack = 0.5;
  std::vector<geom::Aabb> boxes = geom::cover_model(model, options).boxes;
  for (geom::Aabb& box : boxes) box = geom::grow(box, Vec3::Constant(1e-3 + model.blur));
  return support::outcome_of(support::held(boxes, file.marks), model.skipped);
}

}  // namespace left_out
