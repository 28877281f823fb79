#pragma once

// The boxes of a group of tiles, and what finds them, in one block of memory.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "box_tree.h"
#include "huge_arena.h"
#include "nearest_hints.h"
#include "skyline.h"

namespace geom {

// What a tree of all boxes of a map has besides.
struct FirstLooks {
  NearestHints hints;
  Skyline skyline;
};

// The head of the block. The nodes lie right behind it, so that no place is read to find them. All
// are in the order of the tree's leaves, so that boxes that are asked together lie together.
struct alignas(HugeArena::kAlign) GroupTree {
  const Aabb* grown = nullptr;
  const Aabb* by_vehicle = nullptr;     // grown without the margin; `grown` where that is the same
  const std::uint32_t* name = nullptr;  // how far each is from the first
  std::size_t first = 0;                // index in the map of the group's first box
  std::size_t count = 0;                // boxes
  std::size_t bytes = 0;                // about
  bool in_arena = false;
  std::unique_ptr<const FirstLooks> looks;  // of a tree of all boxes
  TreeFrame frame;

  const BoxNode* nodes() const { return reinterpret_cast<const BoxNode*>(this + 1); }
};

// Gives back what a group takes, but not what an arena gave.
struct ReleaseGroup {
  void operator()(const GroupTree* tree) const;
};
using OwnedGroup = std::unique_ptr<const GroupTree, ReleaseGroup>;

// What a GroupTree is made of. All lists are in the order of the boxes that the tree was built of.
struct GroupParts {
  const BuiltTree& built;
  std::span<const Aabb> grown;
  std::span<const Aabb> boxes;          // of the map, not grown; `first` and on
  std::optional<Vec3> by_vehicle = {};  // half sizes without the margin, where there is one
  std::span<const std::uint32_t> names;
  std::size_t first = 0;
  std::unique_ptr<const FirstLooks> looks;
};

// From an arena where there is one, which must outlive the group. Throws std::bad_alloc.
OwnedGroup group_tree(GroupParts parts, HugeArena* arena);

}  // namespace geom
