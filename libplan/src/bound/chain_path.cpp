#include "chain_path.h"

#include <algorithm>
#include <cmath>

namespace plan {
namespace {

constexpr double kOff = 1e-3;  // metres that bends keep from the edges
constexpr int kSlides = 20;    // rounds of moving them along

double off_line(const EdgePart& part, const Vec3& p) {
  const int a = (part.axis + 1) % 3;
  const int b = (part.axis + 2) % 3;
  return std::hypot(p[a] - part.low[a], p[b] - part.low[b]);
}

// The bend moved to where the way by it is straight once both legs lie in a plane.
void slide(const EdgePart& part, const Vec3& before, const Vec3& after, Vec3& bend) {
  const double d1 = off_line(part, before);
  const double d2 = off_line(part, after);
  if (!(d1 + d2 > 0)) return;
  const int k = part.axis;
  const double at = (before[k] * d2 + after[k] * d1) / (d1 + d2);
  bend[k] = std::clamp(at, part.low[k], part.high[k]);
}

void move_outside(const EdgePart& part, Vec3& bend) {
  if (part.is_corner()) return;
  bend[(part.axis + 1) % 3] += kOff * part.outward[0];
  bend[(part.axis + 2) % 3] += kOff * part.outward[1];
}

}  // namespace

Vec3 beside_middle(const EdgePart& part) {
  Vec3 p = 0.5 * (part.low + part.high);
  move_outside(part, p);
  return p;
}

geom::Polyline chain_path(const std::vector<EdgePart>& parts, const Vec3& from, const Vec3& to) {
  geom::Polyline path{from};
  for (const EdgePart& part : parts) path.push_back(0.5 * (part.low + part.high));
  path.push_back(to);
  for (int round = 0; round < kSlides; ++round) {
    for (std::size_t i = 1; i + 1 < path.size(); ++i) {
      if (parts[i - 1].is_corner()) continue;
      slide(parts[i - 1], path[i - 1], path[i + 1], path[i]);
    }
  }
  for (std::size_t i = 1; i + 1 < path.size(); ++i) move_outside(parts[i - 1], path[i]);
  return path;
}

}  // namespace plan
