#pragma once

// The two levels of a collision structure: an Embree scene over groups of neighbouring tiles, and
// one a group over its boxes, built on first touch and given up past the budget. A small map is one
// group and has no upper level.

#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "embree_boxes.h"
#include "geom/collision/collision.h"
#include "nearest_hints.h"
#include "skyline.h"

namespace geom {

// Boxes [first, first + count) of the map.
struct BoxRun {
  std::size_t first = 0;
  std::size_t count = 0;
};

// The boxes of a group, and what finds them.
struct GroupScene {
  EmbreeBoxes embree;
  std::vector<std::size_t> box;  // ascending: their indices in the map
  std::vector<Aabb> grown;
  std::vector<Aabb> by_vehicle;  // grown without the margin; empty where that is the same
  Skyline skyline;
  NearestHints hints;

  // For the next search, where the box is of this group.
  void remember(std::size_t map_box, std::atomic<std::uint32_t>& hint) const;
  const Aabb& without_margin(std::size_t i) const {
    return by_vehicle.empty() ? grown[i] : by_vehicle[i];
  }
  std::size_t bytes() const;  // about
};

// Tiles whose boxes share a scene.
struct Group {
  std::span<const BoxRun> runs;                   // ascending; none is empty
  std::size_t count = 0;                          // boxes
  std::atomic<const GroupScene*> scene{nullptr};  // null until touched, and again once given up
  std::atomic<int> users{0};                      // queries inside; never given up while > 0
  std::atomic<bool> touched{false};               // since the clock's hand last passed
  bool built = false;                             // ever

  Group() = default;
  Group(const Group&) = delete;
  Group& operator=(const Group&) = delete;
  ~Group() { delete scene.load(); }
};

struct CollisionScene::Impl {
  BoxMap map;
  std::span<const Aabb> boxes;  // of the map
  Vehicle vehicle;
  double margin;
  Vec3 half;
  std::size_t budget;
  bool keeps_all = false;  // the whole map surely fits the budget: no group is ever given up
  std::optional<Aabb> free_bounds;
  EmbreeBoxes top;
  Aabb reach;                      // of all grown boxes, where there are any
  std::vector<Aabb> group_extent;  // grown
  std::vector<Group> groups;
  std::vector<BoxRun> runs;  // of all groups, one group after the other
  std::mutex building;       // one scene at a time

  mutable std::mutex keeping;       // guards what follows, and taking scenes away; taken last
  std::vector<std::uint32_t> kept;  // the groups with a scene, around the clock
  std::size_t hand = 0;             // where in `kept` the clock stands
  std::size_t bytes = 0;            // of all scenes
  CollisionCounts counts;
  std::size_t read = 0;  // bytes of boxes, since the mapped files were last trimmed

  Impl(BoxMap m, Vehicle v, double mg, const CollisionOptions& options);

  // The group's scene, built if need be. It stays while the caller counts among `users`, and for
  // good where keeps_all.
  const GroupScene& touch(std::size_t g) {
    const GroupScene* scene = groups[g].scene.load();
    return scene ? *scene : build_group(g);
  }
  void group_tiles(double wanted);
  const GroupScene& build_group(std::size_t g);
  std::unique_ptr<GroupScene> made_scene(const Group& group) const;
  bool make_room() noexcept;
  const GroupScene* kept_scene(const Group& group);
  void keep(std::size_t g, std::unique_ptr<GroupScene> scene);
  void give_up(std::size_t but) noexcept;
};

// Counts a query among the users of a group.
class Use {
 public:
  explicit Use(Group& group) : group_(group) {
    group_.users.fetch_add(1);
    if (!group_.touched.load(std::memory_order_relaxed)) {
      group_.touched.store(true, std::memory_order_relaxed);
    }
  }
  ~Use() { group_.users.fetch_sub(1); }
  Use(const Use&) = delete;
  Use& operator=(const Use&) = delete;

 private:
  Group& group_;
};

// Calls f(scene) for a query inside a group, whose scene stays that long. Throws where it cannot be
// built.
template <class F>
auto visit(CollisionScene::Impl& impl, std::size_t g, const F& f) {
  if (impl.keeps_all) return f(impl.touch(g));
  const Use use(impl.groups[g]);  // counted before the scene is read
  return f(impl.touch(g));
}

// What went wrong inside a query. Embree's functions are C and drop exceptions, so callbacks keep
// them here, and whoever called Embree throws them on: a query in which anything went wrong has no
// answer.
class Failure {
 public:
  void keep_current() noexcept {
    if (!what_) what_ = std::current_exception();
  }
  void rethrow() const {
    if (what_) std::rethrow_exception(what_);
  }

 private:
  std::exception_ptr what_;
};

}  // namespace geom
