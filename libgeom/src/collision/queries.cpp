#include "queries.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "box_walk.h"
#include "geom/base/precondition.h"
#include "meeting_boxes.h"

namespace geom {
namespace {

bool closer(const Nearest& a, const Nearest& b) {
  return std::tie(a.distance, a.box) < std::tie(b.distance, b.box);
}

// The nearest so far: a heap at the start of `room`, the worst on top.
class NearestFound {
 public:
  NearestFound(std::span<Nearest> room, double radius) : room_(room), radius_(radius) {}

  double radius() const { return radius_; }  // boxes further than this are of no interest

  void limit(double radius) { radius_ = std::min(radius_, radius); }

  // Whether it is among them now.
  bool add(const Nearest& next) {
    if (next.distance > radius_) return false;
    if (room_.size() == 1) {
      if (count_ == 1 && !closer(next, room_.front())) return false;
      room_.front() = next;
      count_ = 1;
      radius_ = next.distance;
      return true;
    }
    if (count_ == room_.size()) {
      if (!closer(next, room_.front())) return false;
      std::pop_heap(room_.begin(), end(), closer);
      room_.back() = next;
    } else {
      room_[count_++] = next;
    }
    std::push_heap(room_.begin(), end(), closer);
    if (count_ == room_.size()) radius_ = room_.front().distance;
    return true;
  }

  std::size_t sort() {
    std::sort_heap(room_.begin(), end(), closer);
    return count_;
  }

 private:
  std::span<Nearest>::iterator end() const {
    return room_.begin() + static_cast<std::ptrdiff_t>(count_);
  }

  std::span<Nearest> room_;
  double radius_;
  std::size_t count_ = 0;
};

// A tree looks at its extent itself, but is not built for nothing.
bool is_built(const CollisionScene::Impl& impl, std::size_t g) {
  return impl.groups[g].tree.load(std::memory_order_relaxed) != nullptr;
}

// A question as trees take it: the one that all share, or, where a map is too large for that, one
// for each group, of which the last is kept.
template <class Asked>
class Question {
 public:
  using InTree = decltype(std::declval<Asked>().in(TreeFrame()));

  Question(const CollisionScene::Impl& impl, const Asked& asked)
      : asked_(asked), shared_(asked.in(impl.top.frame)), one_frame_(impl.one_frame) {}

  const InTree& shared() const { return shared_; }
  const InTree& of(const GroupTree& group) {
    return one_frame_ ? shared_ : own_.emplace(asked_.in(group.frame));
  }

 private:
  Asked asked_;
  InTree shared_;
  bool one_frame_;
  std::optional<InTree> own_;
};

// overlap() without a branch: nearly all that are looked at do.
inline bool meet(const Aabb& a, const Aabb& b) {
  bool out = true;
#pragma GCC unroll 3
  for (int i = 0; i < 3; ++i) out = out & (a.min[i] <= b.max[i]) & (b.min[i] <= a.max[i]);
  return out;
}

// What is asked of trees, of boxes and of the skyline.
struct SegmentAsked {
  const Vec3& a;
  const Vec3& b;

  SegmentInTree in(const TreeFrame& frame) const { return {frame, a, b}; }
  bool meets(const Aabb& box) const { return segment_hits(a, b, box); }
  bool passes_over(const Skyline& skyline) const { return skyline.clears(a, b); }
};

// A point is a region too, which takes fewer operations than a segment.
struct PointAsked {
  const Vec3& a;
  const Vec3& b;  // the same

  RegionInTree in(const TreeFrame& frame) const { return {frame, {a, a}}; }
  bool meets(const Aabb& box) const { return meet({a, a}, box); }
  bool passes_over(const Skyline& skyline) const { return skyline.clears(a); }
};

// Calls seen(group, k) for grown boxes k of groups that meet it, until that returns true; returns
// whether it did. Where `first`, the first of them ends the search.
template <bool first, class Asked, class Seen>
bool find_hit(CollisionScene::Impl& impl, const Asked& asked, const Seen& seen) {
  const GroupTree* const whole = whole_tree(impl);
  if (whole && asked.passes_over(whole->looks->skyline)) return false;
  Question question(impl, asked);
  return with_lanes([&](auto lanes) SKYWAY_ANY_LANES {
    using Lanes = decltype(lanes);
    const auto hits_group = [&](const GroupTree& group) SKYWAY_ANY_LANES {
      const auto see = [&](std::size_t k) SKYWAY_ANY_LANES { return seen(group, k) || first; };
      const auto hits = [&](std::size_t k)
                            SKYWAY_ANY_LANES { return asked.meets(group.grown[k]) && see(k); };
      if constexpr (first) {
        return any_meeting<Lanes>(group.nodes(), question.of(group), hits, see);
      } else {
        return any_meeting<Lanes>(group.nodes(), question.of(group), hits);
      }
    };
    if (whole) return hits_group(*whole);
    return any_meeting<Lanes>(nodes_around(impl, asked.a, asked.b), question.shared(),
                              [&](std::size_t g) SKYWAY_ANY_LANES {
                                return (is_built(impl, g) || asked.meets(impl.extent(g))) &&
                                       visit(impl, g, hits_group);
                              });
  });
}

template <bool first, class Seen>
bool find_hit(CollisionScene::Impl& impl, const Vec3& a, const Vec3& b, const Seen& seen) {
  return a == b ? find_hit<first>(impl, PointAsked{a, b}, seen)
                : find_hit<first>(impl, SegmentAsked{a, b}, seen);
}

}  // namespace

bool hits_any(CollisionScene::Impl& impl, const Vec3& a, const Vec3& b) {
  return find_hit<true>(impl, a, b, [](const GroupTree&, std::size_t) { return true; });
}

std::optional<Aabb> blocking_box(CollisionScene::Impl& impl, const Vec3& a, const Vec3& b) {
  std::optional<Aabb> box;
  find_hit<true>(impl, a, b, [&](const GroupTree& group, std::size_t k) {
    box = group.grown[k];
    return true;
  });
  return box;
}

std::vector<std::size_t> blocking_boxes(CollisionScene::Impl& impl, const Vec3& a, const Vec3& b) {
  std::vector<std::size_t> boxes;
  find_hit<false>(impl, a, b, [&](const GroupTree& group, std::size_t k) {
    boxes.push_back(group.first + group.name[k]);
    return false;
  });
  std::sort(boxes.begin(), boxes.end());
  return boxes;
}

namespace {

struct NearAsked {
  const Vec3& p;

  PointInTree in(const TreeFrame& frame) const { return {frame, p}; }
};

// Adds what is near of a group. Returns which box came last among the nearest, if one did.
template <class Lanes>
SKYWAY_ANY_LANES inline std::uint32_t search(const GroupTree& group, const PointInTree& at,
                                             const Vec3& p, NearestFound& found) {
  std::uint32_t last = NearestHints::kNone;
  each_near<Lanes>(group.nodes(), at, found.radius(), [&](std::size_t k) SKYWAY_ANY_LANES {
    if (found.add({group.first + group.name[k], distance(p, group.by_vehicle[k])})) {
      last = static_cast<std::uint32_t>(k);
    }
    return found.radius();
  });
  return last;
}

// The same of the one nearest, from what an earlier search found nearby.
template <class Lanes>
SKYWAY_ANY_LANES inline void search_by_hint(const GroupTree& group, const PointInTree& at,
                                            const Vec3& p, NearestFound& found) {
  std::atomic<std::uint32_t>& hint = group.looks->hints.at(p);
  const std::uint32_t known = hint.load(std::memory_order_relaxed);
  if (known != NearestHints::kNone) found.limit(distance(p, group.by_vehicle[known]));
  const std::uint32_t last = search<Lanes>(group, at, p, found);
  if (known == NearestHints::kNone && last != NearestHints::kNone) {
    hint.store(last, std::memory_order_relaxed);
  }
}

// Whether all that is as near as `radius` is below a node of nodes_around.
bool lies_in(const CollisionScene::Impl& impl, const BoxNode* nodes, const Vec3& p, double radius) {
  if (!(radius <= kFarthest)) return false;
  // Wider than what distances and sums lose.
  const Vec3 reach = Vec3::Constant(radius * (1 + 1e-9) + 1e-6);
  return nodes_around(impl, p - reach, p + reach) == nodes;
}

}  // namespace

std::size_t find_nearest(CollisionScene::Impl& impl, const Vec3& p, double radius,
                         std::span<Nearest> room) {
  NearestFound found(room, radius);
  Question question(impl, NearAsked{p});
  const PointInTree& at = question.shared();
  with_lanes([&](auto lanes) SKYWAY_ANY_LANES {
    using Lanes = decltype(lanes);
    if (const GroupTree* const whole = whole_tree(impl)) {
      const PointInTree& at_whole = question.of(*whole);
      room.size() == 1 ? search_by_hint<Lanes>(*whole, at_whole, p, found)
                       : static_cast<void>(search<Lanes>(*whole, at_whole, p, found));
      return;
    }
    const auto search_group = [&](const GroupTree& group) SKYWAY_ANY_LANES {
      search<Lanes>(group, question.of(group), p, found);
    };
    const auto search_groups = [&](const BoxNode* nodes) {
      each_near<Lanes>(nodes, at, found.radius(), [&](std::size_t g) SKYWAY_ANY_LANES {
        if (is_built(impl, g) || distance(p, impl.extent(g)) <= found.radius()) {
          visit(impl, g, search_group);
        }
        return found.radius();
      });
    };
    // Of one box, what is known already does no harm.
    const BoxNode* const all = impl.top.nodes.data();
    const BoxNode* const around = room.size() == 1 ? nodes_around(impl, p, p) : all;
    search_groups(around);
    if (around != all && !lies_in(impl, around, p, found.radius())) search_groups(all);
  });
  return found.sort();
}

namespace {

struct RegionAsked {
  const Aabb& region;

  RegionInTree in(const TreeFrame& frame) const { return {frame, region}; }
};

}  // namespace

std::optional<std::vector<std::size_t>> find_meeting(CollisionScene::Impl& impl, const Aabb& region,
                                                     std::size_t most) {
  MeetingBoxes found;
  Question question(impl, RegionAsked{region});
  const bool too_many = with_lanes([&](auto lanes) SKYWAY_ANY_LANES {
    using Lanes = decltype(lanes);
    const auto add_group = [&](const GroupTree& group) SKYWAY_ANY_LANES {
      const auto add = [&](std::span<const std::uint32_t> boxes) SKYWAY_ANY_LANES {
        std::size_t* const room = found.room(boxes.size());
        std::size_t count = 0;
        for (const std::uint32_t box : boxes) {
          const std::uint32_t k = box & ~BoxNode::kBox;
          room[count] = group.first + group.name[k];
          count += meet(region, group.grown[k]) ? 1 : 0;
        }
        found.keep(count);
        return found.size() > most;
      };
      return each_in_region<Lanes>(group.nodes(), question.of(group), add);
    };
    if (const GroupTree* const whole = whole_tree(impl)) return add_group(*whole);
    const auto visit_group = [&](std::size_t g) SKYWAY_ANY_LANES {
      return (is_built(impl, g) || meet(region, impl.extent(g))) && visit(impl, g, add_group);
    };
    return any_meeting<Lanes>(nodes_around(impl, region.min, region.max), question.shared(),
                              visit_group);
  });
  if (too_many) return std::nullopt;
  return found.sorted();
}

}  // namespace geom
