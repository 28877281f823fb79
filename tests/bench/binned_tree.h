#pragma once

// The binary tree that the peer of the collision structure is made of: each node is split where
// the surface area heuristic costs least, in bins of the longest way of the centres (Wald 2007).

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include "geom/shape/aabb.h"

namespace bench {

using geom::Aabb;
using geom::Vec3;

// Half the surface.
inline double area(const Aabb& box) {
  const Vec3 d = box.max - box.min;
  return d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
}

// Down to single boxes. The root comes first, and of two siblings the second right after the first.
class BinnedTree {
 public:
  struct Node {
    Aabb bounds;
    std::uint32_t first = 0;  // of its boxes in order()
    std::uint32_t count = 0;
    std::uint32_t child = 0;  // the first of two; none of a single box
  };

  // A part is as dear as the `block`s of boxes that it fills: the width of a node, which is looked
  // at as a whole.
  BinnedTree(std::span<const Aabb> boxes, std::size_t block) : block_(block), order_(boxes.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    items_.reserve(boxes.size());
    for (const std::uint32_t i : order_) {
      items_.push_back({boxes[i], 0.5 * (boxes[i].min + boxes[i].max), i});
    }
    nodes_.reserve(2 * boxes.size());
    nodes_.push_back({*geom::bounds(boxes), 0, static_cast<std::uint32_t>(boxes.size()), 0});
    for (std::size_t k = 0; k < nodes_.size(); ++k) split(k);
    for (std::size_t k = 0; k < order_.size(); ++k) order_[k] = items_[k].box;
    items_ = {};
  }

  std::span<const Node> nodes() const { return nodes_; }
  std::span<const std::uint32_t> order() const { return order_; }

 private:
  static constexpr std::size_t kBins = 16;

  struct Item {
    Aabb bounds;
    Vec3 centre;
    std::uint32_t box;
  };
  struct Bin {
    Aabb bounds{Vec3::Constant(std::numeric_limits<double>::infinity()),
                Vec3::Constant(-std::numeric_limits<double>::infinity())};
    std::size_t count = 0;

    void add(const Bin& other) {
      bounds = geom::merged(bounds, other.bounds);
      count += other.count;
    }
  };
  struct Cut {
    double cost = std::numeric_limits<double>::infinity();
    int axis = 0;
    std::size_t bin = 0;  // the first on the far side
  };

  static std::size_t bin_of(const Item& item, const Aabb& centres, int axis) {
    const double share =
        (item.centre[axis] - centres.min[axis]) / (centres.max[axis] - centres.min[axis]);
    return std::min(kBins - 1, static_cast<std::size_t>(share * kBins));
  }

  double cost(const Bin& part) const {
    return area(part.bounds) * static_cast<double>((part.count + block_ - 1) / block_);
  }

  Cut best_cut(std::span<const Item> items, const Aabb& centres) const {
    Cut best;
    for (int axis = 0; axis < 3; ++axis) {
      if (!(centres.max[axis] > centres.min[axis])) continue;
      std::array<Bin, kBins> bins;
      for (const Item& item : items) bins[bin_of(item, centres, axis)].add({item.bounds, 1});
      std::array<double, kBins> far{};
      Bin part;
      for (std::size_t k = kBins - 1; k > 0; --k) {
        part.add(bins[k]);
        far[k] = part.count > 0 ? cost(part) : std::numeric_limits<double>::infinity();
      }
      part = {};
      for (std::size_t k = 1; k < kBins; ++k) {
        part.add(bins[k - 1]);
        if (part.count == 0) continue;
        if (const double sum = cost(part) + far[k]; sum < best.cost) best = {sum, axis, k};
      }
    }
    return best;
  }

  void split(std::size_t place) {
    const Node node = nodes_[place];
    if (node.count < 2) return;
    const std::span<Item> items(&items_[node.first], node.count);
    Aabb centres{items[0].centre, items[0].centre};
    for (const Item& item : items) centres = geom::merged(centres, {item.centre, item.centre});
    const Cut cut = best_cut(items, centres);
    auto middle = items.begin() + node.count / 2;  // all in one place
    if (cut.bin > 0) {
      middle = std::partition(items.begin(), items.end(), [&](const Item& item) {
        return bin_of(item, centres, cut.axis) < cut.bin;
      });
    }
    nodes_[place].child = static_cast<std::uint32_t>(nodes_.size());
    add(node.first, {items.begin(), middle});
    add(node.first + static_cast<std::uint32_t>(middle - items.begin()), {middle, items.end()});
  }

  void add(std::uint32_t first, std::span<const Item> items) {
    Aabb all = items[0].bounds;
    for (const Item& item : items) all = geom::merged(all, item.bounds);
    nodes_.push_back({all, first, static_cast<std::uint32_t>(items.size()), 0});
  }

  std::size_t block_;
  std::vector<std::uint32_t> order_;
  std::vector<Item> items_;
  std::vector<Node> nodes_;
};

}  // namespace bench
