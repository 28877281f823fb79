#pragma once

// The two levels of a collision structure: an Embree scene over groups of neighbouring tiles, and
// one a group over its boxes, built on first touch and given up, the oldest first, past the budget.
// A small map is one group and has no upper level.

#include <atomic>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "embree_boxes.h"
#include "geom/collision.h"
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
};

struct CollisionScene::Impl {
  BoxMap map;
  Vehicle vehicle;
  double margin;
  Vec3 half;
  std::size_t budget;
  std::optional<Aabb> free_bounds;
  RTCDevice device = nullptr;
  EmbreeBoxes top;
  std::vector<Aabb> group_extent;
  std::vector<Group> groups;
  std::mutex building;            // guards the two below and every change of Group::scene
  std::deque<std::size_t> built;  // groups with a scene, oldest first
  std::size_t bytes = 0;          // of all scenes

  Impl(BoxMap m, Vehicle v, double mg, const CollisionOptions& options);
  ~Impl() {
    for (Group& group : groups) delete group.scene.load();
    if (top.scene) rtcReleaseScene(std::exchange(top.scene, nullptr));
    rtcReleaseDevice(device);
  }

  // The group's scene, built if need be. It stays while the caller counts among `users`.
  const GroupScene& touch(std::size_t g) {
    const GroupScene* scene = groups[g].scene.load();
    return scene ? *scene : build_group(g);
  }
  const GroupScene& build_group(std::size_t g);
  void give_up_oldest(std::size_t keep);
};

// A query inside a group, whose scene stays that long.
class Visit {
 public:
  Visit(CollisionScene::Impl& impl, std::size_t g) : group_(impl.groups[g]) {
    group_.users.fetch_add(1);
    scene_ = &impl.touch(g);
  }
  ~Visit() { group_.users.fetch_sub(1); }
  Visit(const Visit&) = delete;
  Visit& operator=(const Visit&) = delete;

  const GroupScene& scene() const { return *scene_; }

 private:
  Group& group_;
  const GroupScene* scene_;
};

}  // namespace geom
