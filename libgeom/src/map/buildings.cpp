#include "geom/map/buildings.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

namespace geom {
namespace {

constexpr double kTouching = 0.005;  // metres
constexpr std::uint32_t kNone = 0xffffffff;

class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  bool join(std::uint32_t i, std::uint32_t j) {
    const std::uint32_t a = find(i);
    const std::uint32_t b = find(j);
    parent_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

bool overlap(const Aabb& a, const Aabb& b, int axis) {
  return a.min[axis] <= b.max[axis] + kTouching && b.min[axis] <= a.max[axis] + kTouching;
}

// Which walls of `a` are wholly against `b`.
std::uint8_t covered_by(const Aabb& a, const Aabb& b) {
  const auto along = [&](int k) {
    return b.min[k] <= a.min[k] + kTouching && b.max[k] >= a.max[k] - kTouching;
  };
  if (!along(2)) return 0;
  unsigned bits = 0;
  for (int k = 0; k < 2; ++k) {
    if (!along(1 - k)) continue;
    if (b.min[k] < a.min[k] - kTouching && b.max[k] >= a.min[k] - kTouching) bits |= 1u << 2 * k;
    if (b.max[k] > a.max[k] + kTouching && b.min[k] <= a.max[k] + kTouching) bits |= 2u << 2 * k;
  }
  return static_cast<std::uint8_t>(bits);
}

using Key = std::function<std::optional<std::uint64_t>(std::size_t)>;

// Joins boxes of one key that touch, by a sweep from west to east.
class Sweep {
 public:
  Sweep(std::span<const Aabb> boxes, Groups& groups, std::vector<std::uint8_t>& covered)
      : boxes_(boxes), groups_(groups), covered_(covered) {}

  // How many were joined.
  std::size_t run(const Key& key) {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      if (const auto k = key(i)) order.emplace_back(*k, static_cast<std::uint32_t>(i));
    }
    std::sort(order.begin(), order.end(), [&](const auto& a, const auto& b) {
      return std::tuple(a.first, boxes_[a.second].min.x(), a.second) <
             std::tuple(b.first, boxes_[b.second].min.x(), b.second);
    });
    std::size_t joined = 0;
    std::vector<std::uint32_t> open;
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (i > 0 && order[i].first != order[i - 1].first) open.clear();
      joined += meet(order[i].second, open);
    }
    return joined;
  }

 private:
  std::size_t meet(std::uint32_t i, std::vector<std::uint32_t>& open) {
    const Aabb& box = boxes_[i];
    std::erase_if(open,
                  [&](std::uint32_t j) { return boxes_[j].max.x() < box.min.x() - kTouching; });
    std::size_t joined = 0;
    for (const std::uint32_t j : open) {
      if (!overlap(box, boxes_[j], 1) || !overlap(box, boxes_[j], 2)) continue;
      joined += groups_.join(i, j);
      covered_[i] |= covered_by(box, boxes_[j]);
      covered_[j] |= covered_by(boxes_[j], box);
    }
    open.push_back(i);
    return joined;
  }

  std::span<const Aabb> boxes_;
  Groups& groups_;
  std::vector<std::uint8_t>& covered_;
};

double middle_size(std::span<const Aabb> extents) {
  if (extents.empty()) return 1;
  std::vector<double> sizes;
  for (const Aabb& e : extents) sizes.push_back((e.max - e.min).head<2>().norm());
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return *middle;
}

}  // namespace

Buildings buildings_of(const BuildingParts& parts) {
  const auto& [boxes, ids, labels] = parts;
  Buildings out;
  out.covered.resize(boxes.size());
  Groups groups(boxes.size());
  Sweep sweep(boxes, groups, out.covered);
  const Key keys[] = {
      [&](std::size_t i) { return ids.empty() ? std::nullopt : std::optional(ids[i]); },
      [&](std::size_t i) {
        return labels.empty() || labels[i] == 0 ? std::nullopt
                                                : std::optional<std::uint64_t>(labels[i]);
      },
      [&](std::size_t i) {
        return std::optional(static_cast<std::uint64_t>(std::llround(boxes[i].max.z() * 100)));
      }};
  for (const Key& key : keys) {
    if (sweep.run(key) > 0) break;
  }
  std::vector<std::uint32_t> number(boxes.size(), kNone);
  std::vector<Aabb> extents;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const std::uint32_t root = groups.find(static_cast<std::uint32_t>(i));
    if (number[root] == kNone) {
      number[root] = static_cast<std::uint32_t>(extents.size());
      extents.push_back(boxes[i]);
    }
    Aabb& extent = extents[number[root]];
    extent = {extent.min.cwiseMin(boxes[i].min), extent.max.cwiseMax(boxes[i].max)};
    out.of.push_back(number[root]);
  }
  out.count = extents.size();
  out.typical = middle_size(extents);
  return out;
}

}  // namespace geom
