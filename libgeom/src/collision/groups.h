#pragma once

// The two levels of a collision structure: a tree over groups of neighbouring tiles, and one a
// group over its boxes, built on first touch and given up past the budget. A small map gets one
// tree of all its boxes once most of its groups were touched, and needs no upper level then.

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "box_tree.h"
#include "geom/collision/collision.h"
#include "group_tree.h"
#include "huge_arena.h"
#include "tile_groups.h"
#include "top_cells.h"

namespace geom {

// Tiles whose boxes share a tree.
struct Group {
  std::atomic<const GroupTree*> tree{nullptr};  // null until touched, and again once given up
  std::atomic<int> users{0};                    // queries inside; never given up while > 0
  std::atomic<bool> touched{false};             // since the clock's hand last passed
  bool built = false;                           // ever

  Group() = default;
  Group(const Group&) = delete;
  Group& operator=(const Group&) = delete;
  ~Group() { OwnedGroup(tree.load()).reset(); }
};

struct CollisionScene::Impl {
  static constexpr std::size_t kLocks = 16;

  BoxMap map;
  std::span<const Aabb> boxes;  // of the map
  Vehicle vehicle;
  double margin;
  Vec3 half;
  std::size_t budget;
  bool keeps_all = false;  // the whole map surely fits the budget: no group is ever given up
  bool is_small = false;   // and one tree of all boxes is worth it
  std::optional<Aabb> free_bounds;
  TileGroups tiles;                                    // the extents grown
  BoxTree top;                                         // over groups; of one group, only a frame
  bool one_frame = true;                               // of all groups: that of `top`
  Aabb reach;                                          // of all grown boxes, where there are any
  HugeArena arena;                                     // of all groups, where keeps_all
  std::vector<Group> groups;                           // in the order of the leaves of `top`,
  std::vector<std::uint32_t> order;                    // and which of `tiles` each is
  std::unique_ptr<const TopCells> cells;               // over groups, once many were built:
  std::atomic<const TopCells*> known_cells = nullptr;  // the same
  OwnedGroup whole;  // of a small map, all boxes, once most were built:
  std::atomic<const GroupTree*> known_whole = nullptr;  // the same
  std::array<std::mutex, kLocks> building;  // group g is built under building[g % kLocks]

  mutable std::mutex keeping;       // guards what follows, and taking trees away; taken last
  std::vector<std::uint32_t> kept;  // the groups with a tree, around the clock
  std::size_t hand = 0;             // where in `kept` the clock stands
  std::size_t bytes = 0;            // of the trees of groups
  std::size_t built_boxes = 0;      // of all groups that were ever built
  CollisionCounts counts;
  std::size_t read = 0;  // bytes of boxes, since the mapped files were last trimmed

  Impl(BoxMap m, Vehicle v, double mg, const CollisionOptions& options);

  // The group's tree, built if need be. It stays while the caller counts among `users`, and for
  // good where keeps_all.
  const GroupTree& touch(std::size_t g) {
    const GroupTree* tree = groups[g].tree.load();
    return tree ? *tree : build_group(g);
  }
  void group_tiles(double wanted);
  const Aabb& extent(std::size_t g) const { return tiles.extent[order[g]]; }  // of a group, grown
  const GroupTree& build_group(std::size_t g);
  OwnedGroup made_tree(std::size_t g);
  OwnedGroup tree_of(std::size_t first, std::span<const std::uint32_t> names, bool all);
  void make_whole() noexcept;
  void make_cells() noexcept;
  bool make_room() noexcept;
  const GroupTree* kept_tree(const Group& group);
  void keep(std::size_t g, OwnedGroup tree);
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

// Where a walk among groups may begin, of a question between two points.
inline const BoxNode* nodes_around(const CollisionScene::Impl& impl, const Vec3& a, const Vec3& b) {
  const TopCells* const cells = impl.known_cells.load(std::memory_order_acquire);
  const BoxNode* const node = cells ? cells->node(a, b) : nullptr;
  return node ? node : impl.top.nodes.data();
}

// The tree of all boxes, or null while there is none. A map of one group gets it now. It is never
// given up.
inline const GroupTree* whole_tree(CollisionScene::Impl& impl) {
  if (impl.groups.size() == 1) return &impl.touch(0);
  return impl.known_whole.load(std::memory_order_acquire);
}

// Calls f(tree) for a query inside a group, whose tree stays that long. Throws where it cannot be
// built.
template <class F>
[[gnu::always_inline]] inline auto visit(CollisionScene::Impl& impl, std::size_t g, const F& f) {
  if (impl.keeps_all) return f(impl.touch(g));
  const Use use(impl.groups[g]);  // counted before the tree is read
  return f(impl.touch(g));
}

}  // namespace geom
