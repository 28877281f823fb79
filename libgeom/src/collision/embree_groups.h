#pragma once

// The two levels of a collision structure: an Embree scene over groups of neighbouring tiles, and
// one a group over its boxes, built on first touch and given up, the oldest first, past the budget.
// A small map is one group and has no upper level.

#include <atomic>
#include <exception>
#include <list>
#include <mutex>
#include <optional>
#include <vector>

#include "embree_boxes.h"
#include "geom/collision/collision.h"
#include "nearest_hints.h"
#include "skyline.h"

namespace geom {

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
  std::vector<std::size_t> tiles;
  Aabb extent;                                    // grown
  std::atomic<const GroupScene*> scene{nullptr};  // null until touched, and again once given up
  std::atomic<int> users{0};                      // queries inside; never given up while > 0

  Group() = default;
  Group(const Group&) = delete;
  Group& operator=(const Group&) = delete;
  ~Group() { delete scene.load(); }
};

struct CollisionScene::Impl {
  BoxMap map;
  Vehicle vehicle;
  double margin;
  Vec3 half;
  std::size_t budget;
  std::optional<Aabb> free_bounds;
  EmbreeBoxes top;
  Aabb reach;  // of all grown boxes, where there are any
  std::vector<Aabb> group_extent;
  std::vector<Group> groups;
  std::mutex building;           // guards the two below and every change of Group::scene
  std::list<std::size_t> built;  // groups with a scene, oldest first
  std::size_t bytes = 0;         // of all scenes

  Impl(BoxMap m, Vehicle v, double mg, const CollisionOptions& options);

  // The group's scene, built if need be. It stays while the caller counts among `users`.
  const GroupScene& touch(std::size_t g) {
    const GroupScene* scene = groups[g].scene.load();
    return scene ? *scene : build_group(g);
  }
  const GroupScene& build_group(std::size_t g);
  void give_up_oldest(std::size_t keep) noexcept;
};

// Counts a query among the users of a group.
class Use {
 public:
  explicit Use(Group& group) : group_(group) { group_.users.fetch_add(1); }
  ~Use() { group_.users.fetch_sub(1); }
  Use(const Use&) = delete;
  Use& operator=(const Use&) = delete;

 private:
  Group& group_;
};

// A query inside a group, whose scene stays that long. Throws where it cannot be built.
class Visit {
 public:
  Visit(CollisionScene::Impl& impl, std::size_t g) : use_(impl.groups[g]), scene_(impl.touch(g)) {}

  const GroupScene& scene() const { return scene_; }

 private:
  Use use_;  // counted before the scene is read
  const GroupScene& scene_;
};

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
