#include "queries.h"

#include <algorithm>
#include <tuple>

#include "box_walk.h"
#include "geom/base/precondition.h"

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

}  // namespace

namespace {

// Calls seen(group, k) for grown boxes k of groups that the segment meets, until it returns true;
// returns whether it did.
template <class Seen>
bool find_hit(CollisionScene::Impl& impl, const Vec3& a, const Vec3& b, const Seen& seen) {
  const auto hits_group = [&](const GroupTree& group, const SegmentInTree& s) {
    return any_on_segment(group.nodes(), s, [&](std::size_t k) {
      return segment_hits(a, b, group.grown[k]) && seen(group, k);
    });
  };
  if (impl.groups.size() == 1) {
    const GroupTree& group = impl.touch(0);  // the only group is never given up
    return !group.looks->skyline.clears(a, b) &&
           hits_group(group, SegmentInTree(group.frame, a, b));
  }
  const SegmentInTree s(impl.top.frame, a, b);
  return any_on_segment(nodes_around(impl, a, b), s, [&](std::size_t g) {
    return (is_built(impl, g) || segment_hits(a, b, impl.extent(g))) &&
           visit(impl, g, [&](const GroupTree& group) {
             return hits_group(group, impl.one_frame ? s : SegmentInTree(group.frame, a, b));
           });
  });
}

}  // namespace

bool hits_any(CollisionScene::Impl& impl, const Vec3& a, const Vec3& b) {
  return find_hit(impl, a, b, [](const GroupTree&, std::size_t) { return true; });
}

std::optional<Aabb> blocking_box(CollisionScene::Impl& impl, const Vec3& a, const Vec3& b) {
  std::optional<Aabb> box;
  find_hit(impl, a, b, [&](const GroupTree& group, std::size_t k) {
    box = group.grown[k];
    return true;
  });
  return box;
}

std::vector<std::size_t> blocking_boxes(CollisionScene::Impl& impl, const Vec3& a, const Vec3& b) {
  std::vector<std::size_t> boxes;
  find_hit(impl, a, b, [&](const GroupTree& group, std::size_t k) {
    boxes.push_back(group.first + group.name[k]);
    return false;
  });
  std::sort(boxes.begin(), boxes.end());
  return boxes;
}

namespace {

// Adds what is near of a group. Returns which box came last among the nearest, if one did.
std::uint32_t search(const GroupTree& group, const PointInTree& at, const Vec3& p,
                     NearestFound& found) {
  std::uint32_t last = NearestHints::kNone;
  each_near(group.nodes(), at, found.radius(), [&](std::size_t k) {
    if (found.add({group.first + group.name[k], distance(p, group.by_vehicle[k])})) {
      last = static_cast<std::uint32_t>(k);
    }
    return found.radius();
  });
  return last;
}

// The same of the one nearest, from what an earlier search found nearby.
void search_by_hint(const GroupTree& group, const PointInTree& at, const Vec3& p,
                    NearestFound& found) {
  std::atomic<std::uint32_t>& hint = group.looks->hints.at(p);
  const std::uint32_t known = hint.load(std::memory_order_relaxed);
  if (known != NearestHints::kNone) found.limit(distance(p, group.by_vehicle[known]));
  const std::uint32_t last = search(group, at, p, found);
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
  if (impl.groups.size() == 1) {
    const GroupTree& group = impl.touch(0);
    const PointInTree at(group.frame, p);
    if (room.size() == 1) {
      search_by_hint(group, at, p, found);
    } else {
      search(group, at, p, found);
    }
    return found.sort();
  }
  const PointInTree at(impl.top.frame, p);
  const auto search_groups = [&](const BoxNode* nodes) {
    each_near(nodes, at, found.radius(), [&](std::size_t g) {
      if (is_built(impl, g) || distance(p, impl.extent(g)) <= found.radius()) {
        visit(impl, g, [&](const GroupTree& group) {
          search(group, impl.one_frame ? at : PointInTree(group.frame, p), p, found);
        });
      }
      return found.radius();
    });
  };
  // Of one box, what is known already does no harm.
  const BoxNode* const all = impl.top.nodes.data();
  const BoxNode* const around = room.size() == 1 ? nodes_around(impl, p, p) : all;
  search_groups(around);
  if (around != all && !lies_in(impl, around, p, found.radius())) search_groups(all);
  return found.sort();
}

std::optional<std::vector<std::size_t>> find_meeting(CollisionScene::Impl& impl, const Aabb& region,
                                                     std::size_t most) {
  std::vector<std::size_t> found;
  const RegionInTree r(impl.top.frame, region);
  const auto too_many_of = [&](std::size_t g) {
    return visit(impl, g, [&](const GroupTree& group) {
      return any_in_region(group.nodes(), impl.one_frame ? r : RegionInTree(group.frame, region),
                           [&](std::size_t k) {
                             if (!overlap(region, group.grown[k])) return false;
                             found.push_back(group.first + group.name[k]);
                             return found.size() > most;
                           });
    });
  };
  const bool too_many =
      impl.groups.size() == 1
          ? too_many_of(0)
          : any_in_region(nodes_around(impl, region.min, region.max), r, [&](std::size_t g) {
              return (is_built(impl, g) || overlap(region, impl.extent(g))) && too_many_of(g);
            });
  if (too_many) return std::nullopt;
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace geom
