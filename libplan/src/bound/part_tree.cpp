#include "part_tree.h"

#include <algorithm>
#include <utility>

#include "line_label.h"

namespace plan {
namespace {

constexpr std::uint32_t kLeaf = 16;

EdgePart part_of(const geom::Aabb& box) { return {box.min, box.max, kCorner, {}}; }

std::vector<geom::Aabb> boxes_of(const std::vector<EdgePart>& parts) {
  std::vector<geom::Aabb> out;
  out.reserve(parts.size());
  for (const EdgePart& part : parts) out.push_back({part.low, part.high});
  return out;
}

}  // namespace

PartTree::PartTree(std::vector<EdgePart> parts)
    : parts_(std::move(parts)), tree_(boxes_of(parts_), kLeaf) {}

std::vector<std::uint32_t> PartTree::within(const Vec3& from, const Vec3& to, double length) const {
  std::vector<std::uint32_t> out;
  const EdgePart ends[2] = {{from, from, kCorner, {}}, {to, to, kCorner, {}}};
  const auto near = [&](const EdgePart& part) {
    return least_distance(ends[0], part) + least_distance(part, ends[1]) < length;
  };
  std::vector<std::uint32_t> open;
  if (!tree_.nodes.empty()) open.push_back(0);
  while (!open.empty()) {
    const MedianTree::Node& n = tree_.nodes[open.back()];
    open.pop_back();
    if (!near(part_of(n.box))) continue;
    if (n.count == 0) {
      open.push_back(n.begin);
      open.push_back(n.begin + 1);
      continue;
    }
    for (std::uint32_t i = n.begin; i < n.begin + n.count; ++i) {
      if (near(parts_[tree_.order[i]])) out.push_back(tree_.order[i]);
    }
  }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace plan
