#include "part_tree.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "line_label.h"

namespace plan {
namespace {

constexpr std::uint32_t kLeaf = 16;

EdgePart part_of(const geom::Aabb& box) { return {box.min, box.max, kCorner, {}}; }

}  // namespace

PartTree::PartTree(std::vector<EdgePart> parts) : parts_(std::move(parts)), order_(parts_.size()) {
  std::iota(order_.begin(), order_.end(), 0);
  if (parts_.empty()) return;
  nodes_.emplace_back();
  build(0, 0, static_cast<std::uint32_t>(parts_.size()));
}

void PartTree::build(std::uint32_t node, std::uint32_t begin, std::uint32_t end) {
  geom::Aabb around{parts_[order_[begin]].low, parts_[order_[begin]].high};
  for (std::uint32_t i = begin; i < end; ++i) {
    const EdgePart& part = parts_[order_[i]];
    around = geom::merged(around, {part.low, part.high});
  }
  nodes_[node].box = around;
  if (end - begin <= kLeaf) {
    nodes_[node].begin = begin;
    nodes_[node].count = end - begin;
    return;
  }
  int axis = 0;
  (around.max - around.min).maxCoeff(&axis);
  const std::uint32_t middle = begin + (end - begin) / 2;
  const auto key = [&](std::uint32_t i) {
    return std::pair(parts_[i].low[axis] + parts_[i].high[axis], i);
  };
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  const auto first = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node].begin = first;
  nodes_.resize(nodes_.size() + 2);
  build(first, begin, middle);
  build(first + 1, middle, end);
}

std::vector<std::uint32_t> PartTree::within(const Vec3& from, const Vec3& to, double length) const {
  std::vector<std::uint32_t> out;
  const EdgePart ends[2] = {{from, from, kCorner, {}}, {to, to, kCorner, {}}};
  const auto near = [&](const EdgePart& part) {
    return least_distance(ends[0], part) + least_distance(part, ends[1]) < length;
  };
  std::vector<std::uint32_t> open;
  if (!nodes_.empty()) open.push_back(0);
  while (!open.empty()) {
    const Node& n = nodes_[open.back()];
    open.pop_back();
    if (!near(part_of(n.box))) continue;
    if (n.count == 0) {
      open.push_back(n.begin);
      open.push_back(n.begin + 1);
      continue;
    }
    for (std::uint32_t i = n.begin; i < n.begin + n.count; ++i) {
      if (near(parts_[order_[i]])) out.push_back(order_[i]);
    }
  }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace plan
