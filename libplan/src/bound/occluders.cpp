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

// A segment, for slab tests in rounded numbers.
struct Segment {
  Vec3 from;
  Vec3 inverse;  // 1 / what the segment has of each axis; 0 for nothing

  Segment() = default;
  Segment(const Vec3& a, const Vec3& b) : from(a) {
    for (int i = 0; i < 3; ++i) inverse[i] = a[i] == b[i] ? 0 : 1 / (b[i] - a[i]);
  }
  bool meets(const Aabb& box) const {
    double enter = 0;
    double leave = 1;
    for (int i = 0; i < 3; ++i) {
      const double low = box.min[i] - from[i];
      const double high = box.max[i] - from[i];
      if (inverse[i] == 0) {
        if (low > 0 || high < 0) return false;
        continue;
      }
      const double a = low * inverse[i];
      const double b = high * inverse[i];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    return enter <= leave;
  }
};

// The segments between the ends of two parts, worked out as they are asked for.
class Ends {
 public:
  Ends(const EdgePart& a, const EdgePart& b)
      : a_(a), b_(b), all_((a.is_corner() ? 1 : 2) * (b.is_corner() ? 1 : 2)) {}

  bool all_meet(const Aabb& box) {
    for (int n = 0; n < all_; ++n) {
      if (n == known_) add();
      if (!segments_[n].meets(box)) return false;
    }
    return true;
  }

 private:
  void add() {
    const bool high = a_.is_corner() ? false : known_ & 1;
    const bool other = a_.is_corner() ? known_ & 1 : known_ == 1 || known_ == 2;
    segments_[known_++] = Segment(high ? a_.high : a_.low, other ? b_.high : b_.low);
  }

  const EdgePart& a_;
  const EdgePart& b_;
  const int all_;
  int known_ = 0;
  Segment segments_[4];
};

Vec3 middle(const EdgePart& part) { return 0.5 * (part.low + part.high); }

void put_first(Hints& hints, std::uint32_t occluder) {
  auto* at = std::find(hints.begin(), hints.end() - 1, occluder);
  std::move_backward(hints.begin(), at, at + 1);
  hints.front() = occluder;
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

// Whether all_meet() of one of the hints.
template <class AllMeet>
bool Occluders::first_of(Hints& hints, const AllMeet& all_meet) const {
  for (const std::uint32_t hint : hints) {
    if (hint >= boxes_.size() || !all_meet(boxes_[hint])) continue;
    put_first(hints, hint);
    return true;
  }
  return false;
}

bool Occluders::hinted(const EdgePart& a, const EdgePart& b, Hints& hints) const {
  Ends ends(a, b);
  return first_of(hints, [&](const Aabb& box) { return ends.all_meet(box); });
}

// What is hidden from a place by something convex is convex: a box is where its corners are.
bool Occluders::hinted(const EdgePart& a, const Aabb& b, Hints& hints) const {
  Segment segments[16];
  const unsigned all = a.is_corner() ? 8 : 16;
  unsigned known = 0;
  const auto segment = [&](unsigned n) {
    Vec3 corner;
    for (int k = 0; k < 3; ++k) corner[k] = n >> k & 1 ? b.max[k] : b.min[k];
    return Segment(n < 8 ? a.low : a.high, corner);
  };
  return first_of(hints, [&](const Aabb& box) {
    for (unsigned n = 0; n < all; ++n) {
      if (n == known) segments[known++] = segment(n);
      if (!segments[n].meets(box)) return false;
    }
    return true;
  });
}

View Occluders::between(const EdgePart& a, const EdgePart& b, Hints& hints) const {
  if (boxes_.empty()) return View::clear;
  if (hinted(a, b, hints)) return View::hidden;
  Ends ends(a, b);
  const Segment segment(middle(a), middle(b));
  View view = View::clear;
  std::uint32_t open[128];
  int count = 0;
  open[count++] = 0;
  while (count > 0) {
    const MedianTree::Node& n = tree_.nodes[open[--count]];
    if (!segment.meets(n.box)) continue;
    if (n.count == 0) {
      open[count++] = n.begin;
      open[count++] = n.begin + 1;
      continue;
    }
    for (std::uint32_t j = n.begin; j < n.begin + n.count; ++j) {
      if (!segment.meets(boxes_[j])) continue;
      view = View::partial;
      if (!ends.all_meet(boxes_[j])) continue;
      put_first(hints, j);
      return View::hidden;
    }
  }
  return view;
}

}  // namespace plan
