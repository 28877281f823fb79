#include <algorithm>
#include <numeric>

#include "geom/model/model.h"

namespace geom {
namespace {

constexpr std::size_t kMostCorners = 1000;

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

// Newell's: twice the area in each plane, so the longest axis tells where it is seen best.
Vec3 newell_normal(std::span<const Vec3> corners) {
  Vec3 normal = Vec3::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 a = corners[i] - corners[0];
    const Vec3 b = corners[(i + 1) % corners.size()] - corners[0];
    normal += Vec3(a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
                   a.x() * b.y() - a.y() * b.x());
  }
  return normal;
}

// The polygon seen along one axis, counterclockwise.
class Flat {
 public:
  explicit Flat(std::span<const Vec3> corners) : corners_(corners) {
    const Vec3 normal = newell_normal(corners);
    Eigen::Index axis = 2;
    normal.cwiseAbs().maxCoeff(&axis);
    x_ = (axis + 1) % 3;
    y_ = (axis + 2) % 3;
    if (normal[axis] < 0) std::swap(x_, y_);
  }

  double turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const Vec3& p = corners_[a];
    const Vec3 u = corners_[b] - p;
    const Vec3 v = corners_[c] - p;
    return u[x_] * v[y_] - u[y_] * v[x_];
  }

  bool holds(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t p) const {
    for (const std::uint32_t i : {a, b, c}) {
      if (corners_[p] == corners_[i]) return false;  // a corner met twice, as at a slit
    }
    return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
  }

 private:
  std::span<const Vec3> corners_;
  Eigen::Index x_ = 0;
  Eigen::Index y_ = 1;
};

bool is_ear(const Flat& flat, const std::vector<std::uint32_t>& left, std::size_t i) {
  const std::size_t n = left.size();
  const std::uint32_t a = left[(i + n - 1) % n];
  const std::uint32_t b = left[i];
  const std::uint32_t c = left[(i + 1) % n];
  if (!(flat.turn(a, b, c) >= 0)) return false;
  return std::none_of(left.begin(), left.end(), [&](std::uint32_t p) {
    return p != a && p != b && p != c && flat.holds(a, b, c, p);
  });
}

void add_fan(const std::vector<std::uint32_t>& left, Triangles& out) {
  for (std::size_t i = 1; i + 1 < left.size(); ++i) out.push_back({left[0], left[i], left[i + 1]});
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> polygon_triangles(std::span<const Vec3> corners) {
  std::vector<std::uint32_t> left(corners.size());
  std::iota(left.begin(), left.end(), 0u);
  Triangles out;
  const Flat flat(corners);
  while (left.size() > 3 && left.size() <= kMostCorners) {
    std::size_t ear = 0;
    while (ear < left.size() && !is_ear(flat, left, ear)) ++ear;
    if (ear == left.size()) break;
    const std::size_t n = left.size();
    out.push_back({left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n]});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  add_fan(left, out);
  return out;
}

}  // namespace geom
