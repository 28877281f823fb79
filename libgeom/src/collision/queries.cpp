#include "queries.h"

#include <algorithm>
#include <tuple>

#include "box_walk.h"

namespace geom {
namespace {

// Metres around a point that are searched as they are. Beyond, something near is found first.
constexpr double kSearched = 25;

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

}  // namespace

bool hits_any(CollisionScene::Impl& impl, const Vec3& a, const Vec3& b) {
  const auto hits_group = [&](std::size_t g) {
    return visit(impl, g, [&](const GroupTree& group) {
      if (group.skyline && group.skyline->clears(a, b)) return false;
      return any_on_segment(group.tree, a, b,
                            [&](std::size_t k) { return segment_hits(a, b, group.grown[k]); });
    });
  };
  if (impl.groups.size() == 1) return hits_group(0);
  return any_on_segment(impl.top.tree, a, b, [&](std::size_t k) {
    const std::size_t g = impl.top.order[k];
    // A tree looks at its extent itself, but is not built for nothing.
    return (impl.groups[g].tree.load(std::memory_order_relaxed) ||
            segment_hits(a, b, impl.group_extent[g])) &&
           hits_group(g);
  });
}

namespace {

// Searches a group for the boxes nearest to a point.
class GroupSearch {
 public:
  GroupSearch(const GroupTree& group, const Vec3& p)
      : group_(group), p_(p), boxes_(group.without_margin()) {}

  // How far a box is that is likely near.
  double likely() const { return distance(p_, boxes_[likely_near(group_.tree, p_)]); }

  // Adds what is near. Returns which box came last among the nearest, if one did.
  std::uint32_t all(NearestFound& found) const {
    std::uint32_t last = NearestHints::kNone;
    each_near(group_.tree, p_, found.radius(), [&](std::size_t k) {
      if (found.add({group_.first + group_.name[k], distance(p_, boxes_[k])})) {
        last = static_cast<std::uint32_t>(k);
      }
      return found.radius();
    });
    return last;
  }

  // The same of the one nearest, from what an earlier search found nearby.
  void one(NearestFound& found, const NearestHints& hints) const {
    std::atomic<std::uint32_t>& hint = hints.at(p_);
    const std::uint32_t known = hint.load(std::memory_order_relaxed);
    found.limit(known == NearestHints::kNone ? likely() : distance(p_, boxes_[known]));
    const std::uint32_t last = all(found);
    if (known == NearestHints::kNone && last != NearestHints::kNone) {
      hint.store(last, std::memory_order_relaxed);
    }
  }

 private:
  const GroupTree& group_;
  const Vec3& p_;
  std::span<const Aabb> boxes_;
};

}  // namespace

std::size_t find_nearest(CollisionScene::Impl& impl, const Vec3& p, double radius,
                         std::span<Nearest> room) {
  NearestFound found(room, radius);
  if (impl.groups.size() == 1) {
    const GroupTree& group = impl.touch(0);  // the only group is never given up
    const GroupSearch search(group, p);
    if (room.size() == 1) {
      search.one(found, *group.hints);
    } else {
      search.all(found);
    }
    return found.sort();
  }
  const BoxTree& top = impl.top.tree;
  if (room.size() == 1 && !(radius <= kSearched)) {
    visit(impl, impl.top.order[likely_near(top, p)],
          [&](const GroupTree& group) { found.limit(GroupSearch(group, p).likely()); });
  }
  each_near(top, p, found.radius(), [&](std::size_t k) {
    const std::size_t g = impl.top.order[k];
    if (distance(p, impl.group_extent[g]) <= found.radius()) {
      visit(impl, g, [&](const GroupTree& group) { GroupSearch(group, p).all(found); });
    }
    return found.radius();
  });
  return found.sort();
}

std::optional<std::vector<std::size_t>> find_meeting(CollisionScene::Impl& impl, const Aabb& region,
                                                     std::size_t most) {
  std::vector<std::size_t> found;
  const auto too_many_of = [&](std::size_t g) {
    return visit(impl, g, [&](const GroupTree& group) {
      return any_in_region(group.tree, region, [&](std::size_t k) {
        if (!overlap(region, group.grown[k])) return false;
        found.push_back(group.first + group.name[k]);
        return found.size() > most;
      });
    });
  };
  const bool too_many = impl.groups.size() == 1
                            ? too_many_of(0)
                            : any_in_region(impl.top.tree, region, [&](std::size_t k) {
                                const std::size_t g = impl.top.order[k];
                                return overlap(region, impl.group_extent[g]) && too_many_of(g);
                              });
  if (too_many) return std::nullopt;
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace geom
