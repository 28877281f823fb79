#include "geom/footprint.h"

#include <algorithm>

#include "geom/cover.h"
#include "geom/parallel.h"

namespace geom {
namespace {

// The part [t0, t1] of the segment in the rectangle; false where there is none.
bool clip(const Vec2& a, const Vec2& b, const Aabb& box, double& t0, double& t1) {
  t0 = 0;
  t1 = 1;
  for (int i = 0; i < 2; ++i) {
    const double d = b[i] - a[i];
    if (d == 0) {
      if (a[i] < box.min[i] || a[i] > box.max[i]) return false;
      continue;
    }
    const double u = (box.min[i] - a[i]) / d;
    const double v = (box.max[i] - a[i]) / d;
    t0 = std::max(t0, std::min(u, v));
    t1 = std::min(t1, std::max(u, v));
  }
  return t0 <= t1;
}

// Whether the wall over the segment lies within the boxes. Rounding may say no, never a wrong yes
// by more than the 1e-9 m that cover() rounds outward.
bool wall_covered(const Vec2& a, const Vec2& b, const Footprint& f, std::span<const Aabb> boxes) {
  std::vector<std::pair<double, double>> parts;
  for (const Aabb& box : boxes) {
    double t0;
    double t1;
    if (box.min.z() > f.bottom || box.max.z() < f.top || !clip(a, b, box, t0, t1)) continue;
    parts.emplace_back(t0, t1);
  }
  std::sort(parts.begin(), parts.end());
  double reached = 0;
  for (const auto& [t0, t1] : parts) {
    if (t0 > reached) return false;
    reached = std::max(reached, t1);
  }
  return !parts.empty() && reached >= 1;
}

bool covered(const Footprint& f, std::span<const Aabb> boxes) {
  const auto ring_covered = [&](const std::vector<Vec2>& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (!wall_covered(ring[i], ring[(i + 1) % ring.size()], f, boxes)) return false;
    }
    return true;
  };
  return ring_covered(f.polygon.outer) &&
         std::all_of(f.polygon.holes.begin(), f.polygon.holes.end(), ring_covered);
}

}  // namespace

BoxTable boxes_of(const std::vector<Footprint>& footprints, double slack, const Execution& run) {
  std::vector<std::size_t> first;  // of each feature
  for (std::size_t i = 0; i < footprints.size(); ++i) {
    if (i == 0 || footprints[i].id != footprints[i - 1].id) first.push_back(i);
  }
  std::vector<std::vector<Aabb>> made(first.size());
  parallel_for(first.size(), run, [&](std::size_t k) {
    const std::size_t end = k + 1 < first.size() ? first[k + 1] : footprints.size();
    for (const bool likely : {false, true}) {
      for (std::size_t i = first[k]; i < end; ++i) {
        const Footprint& f = footprints[i];
        if (f.likely_covered != likely || (likely && covered(f, made[k]))) continue;
        for (const Rectangle& r : cover(f.polygon, slack)) {
          made[k].push_back({{r.min.x(), r.min.y(), f.bottom}, {r.max.x(), r.max.y(), f.top}});
        }
      }
    }
  });
  BoxTable table;
  table.labels = {""};
  for (std::size_t k = 0; k < made.size(); ++k) {
    table.boxes.insert(table.boxes.end(), made[k].begin(), made[k].end());
    table.ids.resize(table.boxes.size(), footprints[first[k]].id);
  }
  table.label.resize(table.boxes.size(), 0);
  return table;
}

}  // namespace geom
