#include "occluders.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace plan {
namespace {

constexpr std::uint32_t kLeaf = 4;

using geom::Aabb;

// The box made longer along an axis, both ways, while one grown box holds its whole face and
// reaches further.
void lengthen(const geom::CollisionScene& scene, int axis, Aabb& box) {
  for (const bool up : {false, true}) {
    bool longer = true;
    while (longer) {
      longer = false;
      Aabb face = box;
      (up ? face.min : face.max)[axis] = (up ? box.max : box.min)[axis];
      for (const std::size_t i : scene.boxes_meeting({face.min, face.min})) {
        const Aabb o = scene.grown(i);
        if (!geom::contains(o, face.max)) continue;
        if (up ? o.max[axis] > box.max[axis] : o.min[axis] < box.min[axis]) {
          (up ? box.max : box.min)[axis] = (up ? o.max : o.min)[axis];
          longer = true;
        }
      }
    }
  }
}

// Where two boxes overlap or touch, what has the cross-section of both and the length of both
// together.
std::vector<Aabb> bridges(const geom::CollisionScene& scene, std::size_t i) {
  std::vector<Aabb> out;
  const Aabb box = scene.grown(i);
  for (const std::size_t j : scene.boxes_meeting(box)) {
    if (j <= i) continue;
    const Aabb other = scene.grown(j);
    for (int axis = 0; axis < 3; ++axis) {
      Aabb bridge{box.min.cwiseMax(other.min), box.max.cwiseMin(other.max)};
      bridge.min[axis] = std::min(box.min[axis], other.min[axis]);
      bridge.max[axis] = std::max(box.max[axis], other.max[axis]);
      out.push_back(bridge);
    }
  }
  return out;
}

std::vector<Aabb> lengthened(const geom::CollisionScene& scene) {
  std::vector<Aabb> out;
  for (std::size_t i = 0; i < scene.map().size(); ++i) {
    std::vector<Aabb> some = bridges(scene, i);
    some.push_back(scene.grown(i));
    for (const Aabb& box : some) {
      for (int first = 0; first < 3; ++first) {
        Aabb once = box;
        lengthen(scene, first, once);
        out.push_back(once);
        for (int second = 0; second < 3; ++second) {
          if (second == first) continue;
          Aabb twice = once;
          lengthen(scene, second, twice);
          out.push_back(twice);
        }
      }
    }
  }
  const auto key = [](const Aabb& b) {
    return std::tie(b.min[0], b.min[1], b.min[2], b.max[0], b.max[1], b.max[2]);
  };
  std::sort(out.begin(), out.end(), [&](const Aabb& a, const Aabb& b) { return key(a) < key(b); });
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

// In rounded numbers.
bool meets(const Vec3& from, const Vec3& to, const Aabb& box) {
  double enter = 0;
  double leave = 1;
  for (int i = 0; i < 3; ++i) {
    const double d = to[i] - from[i];
    if (d == 0) {
      if (from[i] < box.min[i] || from[i] > box.max[i]) return false;
      continue;
    }
    const double a = (box.min[i] - from[i]) / d;
    const double b = (box.max[i] - from[i]) / d;
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
    if (!(enter <= leave)) return false;
  }
  return true;
}

bool meets_all(const EdgePart& a, const EdgePart& b, const Aabb& box) {
  if (!meets(a.low, b.low, box)) return false;
  if (!a.is_corner() && !meets(a.high, b.low, box)) return false;
  if (!b.is_corner() && !meets(a.low, b.high, box)) return false;
  return a.is_corner() || b.is_corner() || meets(a.high, b.high, box);
}

}  // namespace

Occluders::Occluders(const geom::CollisionScene& scene) {
  const Aabb& bounds = *scene.free_bounds();
  const auto largest = [](const Aabb& box) {
    return box.min.cwiseAbs().cwiseMax(box.max.cwiseAbs()).maxCoeff();
  };
  for (Aabb box : lengthened(scene)) {
    if (!geom::overlap(box, bounds)) continue;
    const double shrink = std::ldexp(std::max(largest(bounds), largest(box)), -47);
    box.min += Vec3::Constant(shrink);
    box.max -= Vec3::Constant(shrink);
    if ((box.min.array() <= box.max.array()).all()) boxes_.push_back(box);
  }
  arrange();
  std::vector<Aabb> kept;
  for (std::uint32_t i = 0; i < boxes_.size(); ++i) {
    if (!is_inside_another(i)) kept.push_back(boxes_[i]);
  }
  boxes_ = std::move(kept);
  arrange();
}

void Occluders::arrange() {
  tree_ = MedianTree(boxes_, kLeaf);
  std::vector<Aabb> arranged;
  arranged.reserve(boxes_.size());
  for (const std::uint32_t i : tree_.order) arranged.push_back(boxes_[i]);
  boxes_ = std::move(arranged);
}

bool Occluders::is_inside_another(std::uint32_t i) const {
  const auto holds = [](const Aabb& outer, const Aabb& inner) {
    return geom::contains(outer, inner.min) && geom::contains(outer, inner.max);
  };
  const Aabb& box = boxes_[i];
  std::vector<std::uint32_t> open{0};
  while (!open.empty()) {
    const MedianTree::Node& n = tree_.nodes[open.back()];
    open.pop_back();
    if (!holds(n.box, box)) continue;
    if (n.count == 0) {
      open.push_back(n.begin);
      open.push_back(n.begin + 1);
      continue;
    }
    for (std::uint32_t j = n.begin; j < n.begin + n.count; ++j) {
      const Aabb& other = boxes_[j];
      if (j != i && holds(other, box) && (!(other == box) || j < i)) return true;
    }
  }
  return false;
}

bool Occluders::between(const EdgePart& a, const EdgePart& b, std::uint32_t& hint) const {
  if (boxes_.empty()) return false;
  if (hint < boxes_.size() && meets_all(a, b, boxes_[hint])) return true;
  const Aabb around{a.low.cwiseMin(b.low), a.low.cwiseMax(b.low)};
  std::uint32_t open[128];
  int count = 0;
  open[count++] = 0;
  while (count > 0) {
    const MedianTree::Node& n = tree_.nodes[open[--count]];
    if (!geom::overlap(n.box, around) || !meets(a.low, b.low, n.box)) continue;
    if (n.count == 0) {
      open[count++] = n.begin;
      open[count++] = n.begin + 1;
      continue;
    }
    for (std::uint32_t j = n.begin; j < n.begin + n.count; ++j) {
      if (!meets_all(a, b, boxes_[j])) continue;
      hint = j;
      return true;
    }
  }
  return false;
}

}  // namespace plan
