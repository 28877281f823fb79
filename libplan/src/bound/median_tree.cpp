#include "median_tree.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace plan {
namespace {

class Builder {
 public:
  Builder(std::span<const geom::Aabb> boxes, std::uint32_t leaf, MedianTree& tree)
      : boxes_(boxes), leaf_(leaf), tree_(tree) {}

  void build(std::uint32_t node, std::uint32_t begin, std::uint32_t end) {
    std::vector<std::uint32_t>& order = tree_.order;
    geom::Aabb around = boxes_[order[begin]];
    for (std::uint32_t i = begin; i < end; ++i) around = geom::merged(around, boxes_[order[i]]);
    tree_.nodes[node].box = around;
    if (end - begin <= leaf_) {
      tree_.nodes[node].begin = begin;
      tree_.nodes[node].count = end - begin;
      return;
    }
    int axis = 0;
    (around.max - around.min).maxCoeff(&axis);
    const std::uint32_t middle = begin + (end - begin) / 2;
    const auto key = [&](std::uint32_t i) {
      return std::pair(boxes_[i].min[axis] + boxes_[i].max[axis], i);
    };
    std::nth_element(order.begin() + begin, order.begin() + middle, order.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    const auto first = static_cast<std::uint32_t>(tree_.nodes.size());
    tree_.nodes[node].begin = first;
    tree_.nodes.resize(tree_.nodes.size() + 2);
    build(first, begin, middle);
    build(first + 1, middle, end);
  }

 private:
  std::span<const geom::Aabb> boxes_;
  std::uint32_t leaf_;
  MedianTree& tree_;
};

}  // namespace

MedianTree::MedianTree(std::span<const geom::Aabb> boxes, std::uint32_t most_in_a_leaf)
    : order(boxes.size()) {
  std::iota(order.begin(), order.end(), 0);
  if (boxes.empty()) return;
  nodes.emplace_back();
  Builder(boxes, most_in_a_leaf, *this).build(0, 0, static_cast<std::uint32_t>(boxes.size()));
}

}  // namespace plan
