#pragma once

// Points of clouds that are marks.

#include <span>
#include <vector>

#include "geom/cloud/point_cloud.h"
#include "support/left_out.h"

namespace left_out {

using geom::Vec3;

inline std::vector<Vec3> random_places(support::Random& random) {
  std::vector<Vec3> out(static_cast<std::size_t>(1 + random.below(6)));
  for (Vec3& p : out) p = support::random_place(random);
  return out;
}

// What read_cloud(stream, name, sink) made of the marks, to the precision that they were written
// in.
template <class Read>
support::Outcome read_points(const Read& read_cloud, std::istream& in,
                             const support::MarkedFile& file, double precision) {
  std::vector<Vec3> points;
  const geom::CloudCounts counts =
      read_cloud(in, "random", [&](std::span<const geom::CloudPoint> chunk) {
        for (const geom::CloudPoint& p : chunk) points.push_back(p.position);
      });
  if (points.empty()) return support::Outcome::told;  // the tool refuses it
  bool all = true;
  for (const Vec3& mark : file.marks) {
    bool found = false;
    for (const Vec3& p : points) found = found || (p - mark).cwiseAbs().maxCoeff() <= precision;
    all = all && found;
  }
  return support::outcome_of(all, counts.skipped);
}

}  // namespace left_out
