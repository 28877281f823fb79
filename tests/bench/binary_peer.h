#pragma once

// A binary tree beside the collision structure: split by the surface area heuristic, with leaves
// of up to eight boxes where that is cheaper, two siblings side by side, the nearer one first.
// Single precision, each candidate decided in double by the functions of geom.

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "binned_tree.h"
#include "peer_frame.h"

namespace bench {

class BinaryPeer {
 public:
  explicit BinaryPeer(std::span<const Aabb> boxes) : frame_(boxes) {
    const BinnedTree binary(boxes, 1);
    name_.assign(binary.order().begin(), binary.order().end());
    boxes_.reserve(boxes.size());
    for (const std::uint32_t i : name_) boxes_.push_back(boxes[i]);
    const std::vector<bool> leaf = leaves(binary);
    nodes_.emplace_back();
    set(binary, leaf, 0, 0);
  }

  bool hits(const Vec3& a, const Vec3& b) const {
    const PeerSegment s(frame_, a, b);
    const auto enters = [&](const Node& node) { return node.entry(s); };
    return walk(enters, kAlways,
                [&](std::uint32_t k) { return geom::segment_hits(a, b, boxes_[k]); });
  }

  double nearest(const Vec3& p) const {
    const Eigen::Vector3f at = frame_.at(p);
    double best = std::numeric_limits<double>::infinity();
    float limit = std::numeric_limits<float>::infinity();
    const auto square = [&](const Node& node) {
      const float out = node.square(at);
      return out > limit ? kMiss : out;
    };
    const auto still = [&](std::uint32_t node) { return square(nodes_[node]) != kMiss; };
    walk(square, still, [&](std::uint32_t k) {
      const double distance = geom::distance(p, boxes_[k]);
      if (distance < best) limit = frame_.limit(best = distance);
      return false;
    });
    return best;
  }

  std::vector<std::size_t> boxes_meeting(const Aabb& region) const {
    const Eigen::Vector3f low = frame_.at(region.min);
    const Eigen::Vector3f high = frame_.at(region.max);
    std::vector<std::size_t> found;
    found.reserve(kFew);
    const auto meets = [&](const Node& node) { return node.meets(low, high) ? 0.0f : kMiss; };
    walk(meets, kAlways, [&](std::uint32_t k) {
      if (geom::overlap(region, boxes_[k])) found.push_back(name_[k]);
      return false;
    });
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  static constexpr float kMiss = std::numeric_limits<float>::infinity();
  static constexpr auto kAlways = [](std::uint32_t) { return true; };
  static constexpr std::size_t kMostInLeaf = 8;
  static constexpr std::size_t kStack = 1024;

  struct Node {
    float plane[6];
    std::uint32_t first;  // of the boxes of a leaf, else of two children
    std::uint32_t count;  // of boxes; 0: no leaf

    // Where the segment comes in, or kMiss.
    float entry(const PeerSegment& s) const {
      float from = 0;
      float to = 1;
      for (int i = 0; i < 3; ++i) {
        const float low = (plane[i] - s.from[i]) * s.inverse[i];
        const float high = (plane[3 + i] - s.from[i]) * s.inverse[i];
        from = std::max(from, std::min(low, high));
        to = std::min(to, std::max(low, high));
      }
      return from <= to ? from : kMiss;
    }
    float square(const Eigen::Vector3f& at) const {
      float sum = 0;
      for (int i = 0; i < 3; ++i) {
        const float off = std::max(std::max(plane[i] - at[i], at[i] - plane[3 + i]), 0.0f);
        sum += off * off;
      }
      return sum;
    }
    bool meets(const Eigen::Vector3f& low, const Eigen::Vector3f& high) const {
      bool out = true;
      for (int i = 0; i < 3; ++i) out &= plane[i] <= high[i] && low[i] <= plane[3 + i];
      return out;
    }
  };

  // Asks f about the boxes of leaves until it answers true. `key` says where among siblings a node
  // comes, or kMiss; `still` says whether a node that waited is to be looked at.
  template <class Key, class Still, class F>
  bool walk(const Key& key, const Still& still, const F& f) const {
    std::array<std::uint32_t, kStack> open;
    std::size_t count = 0;
    std::uint32_t next = 0;
    if (key(nodes_[0]) == kMiss) return false;
    for (;;) {
      const Node& node = nodes_[next];
      if (node.count == 0) {
        const float first = key(nodes_[node.first]);
        const float second = key(nodes_[node.first + 1]);
        const std::uint32_t nearer = node.first + (second < first ? 1 : 0);
        if (first != kMiss && second != kMiss) open[count++] = 2 * node.first + 1 - nearer;
        next = nearer;
        if (first != kMiss || second != kMiss) continue;
      } else {
        for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
          if (f(k)) return true;
        }
      }
      do {
        if (count == 0) return false;
        next = open[--count];
      } while (!still(next));
    }
  }

  // Where a leaf costs less than looking at two children, in boxes and nodes looked at.
  static std::vector<bool> leaves(const BinnedTree& binary) {
    const auto nodes = binary.nodes();
    std::vector<bool> leaf(nodes.size(), true);
    std::vector<float> cost(nodes.size());
    for (std::size_t k = nodes.size(); k-- > 0;) {
      const auto& node = nodes[k];
      const double whole = area(node.bounds) * node.count;
      const double apart = node.count == 1
                               ? whole
                               : 0.5 * area(node.bounds) + cost[node.child] + cost[node.child + 1];
      leaf[k] = node.count <= kMostInLeaf && whole <= apart;
      cost[k] = static_cast<float>(leaf[k] ? whole : apart);
    }
    return leaf;
  }

  void set(const BinnedTree& binary, const std::vector<bool>& leaf, std::size_t at,
           std::uint32_t from) {
    const auto& part = binary.nodes()[from];
    Node node{};
    for (int i = 0; i < 3; ++i) {
      node.plane[i] = frame_.low(part.bounds, i);
      node.plane[3 + i] = frame_.high(part.bounds, i);
    }
    node.first = leaf[from] ? part.first : static_cast<std::uint32_t>(nodes_.size());
    node.count = leaf[from] ? part.count : 0;
    nodes_[at] = node;
    if (leaf[from]) return;
    nodes_.resize(nodes_.size() + 2);
    set(binary, leaf, node.first, part.child);
    set(binary, leaf, node.first + 1, part.child + 1);
  }

  std::vector<Aabb> boxes_;  // from leaf to leaf
  std::vector<std::uint32_t> name_;
  PeerFrame frame_;
  std::vector<Node> nodes_;
};

}  // namespace bench
