#include "group_tree.h"

#include <new>

namespace geom {
namespace {

constexpr std::align_val_t kAlign{alignof(GroupTree)};
static_assert(alignof(GroupTree) >= alignof(BoxNode) && sizeof(GroupTree) % alignof(BoxNode) == 0);
static_assert(sizeof(BoxNode) % alignof(Aabb) == 0);

// The next part of a block: item(i) for each i of `order`.
template <class T, class F>
const T* lay(std::byte*& at, std::span<const std::uint32_t> order, const F& item) {
  T* const out = reinterpret_cast<T*>(at);
  for (std::size_t k = 0; k < order.size(); ++k) new (out + k) T(item(order[k]));
  at += order.size() * sizeof(T);
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
                            (parts.by_vehicle ? 2 : 1) * parts.grown.size_bytes() +
                            parts.names.size_bytes();
  void* const block = arena ? arena->take(bytes) : ::operator new(bytes, kAlign);
  // Nothing fails from here on.
  auto* const out = new (block) GroupTree;
  auto* at = reinterpret_cast<std::byte*>(out + 1);
  std::uninitialized_copy(nodes.begin(), nodes.end(), reinterpret_cast<BoxNode*>(at));
  at += nodes.size() * sizeof(BoxNode);
  const std::span<const std::uint32_t> order = parts.built.order;
  out->grown = lay<Aabb>(at, order, [&](std::size_t i) { return parts.grown[i]; });
  out->by_vehicle = out->grown;
  if (parts.by_vehicle) {
    out->by_vehicle = lay<Aabb>(at, order, [&](std::size_t i) {
      return grow(parts.boxes[parts.names[i]], *parts.by_vehicle);
    });
  }
  out->name = lay<std::uint32_t>(at, order, [&](std::size_t i) { return parts.names[i]; });
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
