#include "share_outside.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace geom {
namespace {

constexpr double kRounding = 1e-3;  // metres

// The places along an axis where a box begins or ends.
std::vector<double> cuts(std::span<const Aabb> boxes, int axis) {
  std::vector<double> out;
  for (const Aabb& box : boxes) {
    out.push_back(box.min[axis]);
    out.push_back(box.max[axis]);
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

// The volume of all boxes together, from this axis on: slice by slice, where all boxes reach
// through.
double together(std::vector<Aabb> boxes, int axis) {
  if (axis == 3) return boxes.empty() ? 0 : 1;
  double sum = 0;
  const std::vector<double> at = cuts(boxes, axis);
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    std::vector<Aabb> through;
    for (const Aabb& box : boxes) {
      if (box.min[axis] <= at[i] && box.max[axis] >= at[i + 1]) through.push_back(box);
    }
    sum += (at[i + 1] - at[i]) * together(std::move(through), axis + 1);
  }
  return sum;
}

}  // namespace

double share_outside(std::span<const Aabb> boxes) {
  const Aabb all = *bounds(boxes);
  std::vector<Aabb> within;
  for (const Aabb& box : boxes) {
    within.push_back({(box.min - Vec3::Constant(kRounding)).cwiseMax(all.min),
                      (box.max + Vec3::Constant(kRounding)).cwiseMin(all.max)});
  }
  const double whole = (all.max - all.min).prod();
  const double missing = 1 - together(std::move(within), 0) / whole;
  return missing > 1e-12 ? missing : 0;
}

}  // namespace geom
