#include "group_tree.h"

#include <new>

namespace geom {
namespace {

constexpr std::align_val_t kAlign{alignof(GroupTree)};
static_assert(alignof(GroupTree) >= alignof(BoxNode) && sizeof(GroupTree) % alignof(BoxNode) == 0);
static_assert(sizeof(BoxNode) % alignof(Aabb) == 0);

// The next part of a block: the items of a list, in an order of their own.
template <class T>
const T* lay(std::byte*& at, std::span<const T> list, std::span<const std::uint32_t> order) {
  T* const out = reinterpret_cast<T*>(at);
  for (std::size_t i = 0; i < list.size(); ++i) new (out + i) T(list[order[i]]);
  at += list.size_bytes();
  return out;
}

}  // namespace

void ReleaseGroup::operator()(const GroupTree* tree) const {
  const bool in_arena = tree->in_arena;
  std::destroy_at(tree);
  if (!in_arena) ::operator delete(const_cast<GroupTree*>(tree), kAlign);
}

OwnedGroup group_tree(GroupParts parts, HugeArena* arena) {
  const std::vector<BoxNode>& nodes = parts.built.tree.nodes;
  const std::size_t bytes = sizeof(GroupTree) + nodes.size() * sizeof(BoxNode) +
                            parts.grown.size_bytes() + parts.by_vehicle.size_bytes() +
                            parts.names.size_bytes();
  void* const block = arena ? arena->take(bytes) : ::operator new(bytes, kAlign);
  // Nothing fails from here on.
  auto* const out = new (block) GroupTree;
  auto* at = reinterpret_cast<std::byte*>(out + 1);
  std::uninitialized_copy(nodes.begin(), nodes.end(), reinterpret_cast<BoxNode*>(at));
  at += nodes.size() * sizeof(BoxNode);
  out->grown = lay(at, parts.grown, parts.built.order);
  out->by_vehicle =
      parts.by_vehicle.empty() ? out->grown : lay(at, parts.by_vehicle, parts.built.order);
  out->name = lay(at, parts.names, parts.built.order);
  out->first = parts.first;
  out->count = parts.grown.size();
  out->bytes = bytes;
  if (parts.looks) out->bytes += parts.looks->hints.bytes() + parts.looks->skyline.bytes();
  out->in_arena = arena != nullptr;
  out->looks = std::move(parts.looks);
  out->frame = parts.built.tree.frame;
  return OwnedGroup(out);
}

}  // namespace geom
