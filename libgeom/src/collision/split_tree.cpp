#include "split_tree.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "filled_tree.h"

namespace geom {
namespace {

constexpr std::size_t kLanes = BoxNode::kLanes;
constexpr std::size_t kMostBins = 32;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

// Below so many levels a node has parts of equal count: eight levels of sixteen hold 2^32 boxes.
constexpr int kMostSplitDepth = 24;
static_assert(kMostSplitDepth + 8 < BoxTree::kMostDepth);

using Lanes = Eigen::Array4f;  // x, y, z, and 0

struct Hull {
  Lanes low;
  Lanes high;

  static Hull of_nothing() { return {Lanes::Constant(kInfinity), Lanes::Constant(-kInfinity)}; }

  void add(const Lanes& from, const Lanes& to) {
    low = low.min(from);
    high = high.max(to);
  }
  float half_surface() const {
    const Lanes side = high - low;
    return side[0] * (side[1] + side[2]) + side[1] * side[2];
  }
};

struct Item {
  Lanes low;
  Lanes high;
  std::uint32_t box;

  Lanes twice_centre() const { return low + high; }
};

struct Part {
  std::span<Item> items;
  Hull hull = Hull::of_nothing();
  Hull centres = Hull::of_nothing();  // twice

  explicit Part(std::span<Item> all) : items(all) {
    for (const Item& item : items) {
      hull.add(item.low, item.high);
      centres.add(item.twice_centre(), item.twice_centre());
    }
  }
};

// The bins of a part's centres on each axis. An axis on which all centres are equal has scale 0.
class Bins {
 public:
  explicit Bins(const Part& part)
      : count_(std::min(kMostBins, 4 + part.items.size() / 20)), origin_(part.centres.low) {
    const Lanes length = part.centres.high - part.centres.low;
    const float most = 0.99f * static_cast<float>(count_);  // the last centre is in the last bin
    for (int i = 0; i < 4; ++i) scale_[i] = length[i] > 1e-34f ? most / length[i] : 0;
  }

  std::size_t count() const { return count_; }
  bool usable(int axis) const { return scale_[axis] > 0; }

  std::size_t bin(const Item& item, int axis) const {
    return static_cast<std::size_t>((item.twice_centre()[axis] - origin_[axis]) * scale_[axis]);
  }
  Eigen::Array4i bins(const Item& item) const {
    return ((item.twice_centre() - origin_) * scale_).cast<int>();
  }

 private:
  std::size_t count_;
  Lanes origin_;
  Lanes scale_;
};

// The boxes of one bin, or of several.
struct Filled {
  Hull hull;
  std::size_t count;

  static Filled with_nothing() { return {Hull::of_nothing(), 0}; }
  void add(const Filled& other) {
    hull.add(other.hull.low, other.hull.high);
    count += other.count;
  }
  // A node looks at sixteen boxes at once, so a part costs as much as the leaves that it fills.
  float cost() const {
    if (count == 0) return kInfinity;
    return hull.half_surface() * static_cast<float>((count + kLanes - 1) / kLanes);
  }
};

struct Cut {
  float cost = kInfinity;
  int axis = 0;
  std::size_t bin = 0;  // the first on the far side; 0: there is no cut
};

// The cheapest cut along one axis, or `best` if that costs no more.
Cut better_cut(std::span<const Filled> bins, int axis, Cut best) {
  std::array<float, kMostBins> far;
  Filled part = Filled::with_nothing();
  for (std::size_t k = bins.size() - 1; k > 0; --k) {
    part.add(bins[k]);
    far[k] = part.cost();
  }
  part = Filled::with_nothing();
  for (std::size_t k = 1; k < bins.size(); ++k) {
    part.add(bins[k - 1]);
    if (const float cost = part.cost() + far[k]; cost < best.cost) best = {cost, axis, k};
  }
  return best;
}

Cut best_cut(const Part& part, const Bins& bins) {
  std::array<std::array<Filled, kMostBins>, 3> filled;  // as many as there are bins
  for (auto& axis : filled) std::fill_n(axis.begin(), bins.count(), Filled::with_nothing());
  for (const Item& item : part.items) {
    const Eigen::Array4i at = bins.bins(item);
    for (int axis = 0; axis < 3; ++axis) {
      Filled& bin = filled[axis][static_cast<std::size_t>(at[axis])];
      bin.hull.add(item.low, item.high);
      ++bin.count;
    }
  }
  Cut best;
  for (int axis = 0; axis < 3; ++axis) {
    if (bins.usable(axis)) {
      best = better_cut(std::span(filled[axis]).first(bins.count()), axis, best);
    }
  }
  return best;
}

// How many items are on the near side of the best cut, which come first from here on. Half of
// them where no cut parts the centres.
std::size_t split(const Part& part) {
  const Bins bins(part);
  const Cut cut = best_cut(part, bins);
  if (cut.bin == 0) return part.items.size() / 2;
  const auto far = std::partition(part.items.begin(), part.items.end(), [&](const Item& item) {
    return bins.bin(item, cut.axis) < cut.bin;
  });
  return static_cast<std::size_t>(far - part.items.begin());
}

void set_lane(BoxNode& node, std::size_t k, const Lanes& low, const Lanes& high) {
  for (int i = 0; i < 3; ++i) {
    node.plane[i][k] = low[i];
    node.plane[3 + i][k] = high[i];
  }
}

class Splitter {
 public:
  explicit Splitter(std::size_t boxes) { nodes_.reserve(boxes / 4 + 1); }

  // Adds a node over all items of a part, and the nodes below it.
  std::uint32_t add_node(const Part& part, int depth) {
    const auto place = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back(empty_node());
    if (part.items.size() <= kLanes) {
      fill_leaf(nodes_.back(), part.items);
      return place;
    }
    const std::vector<Part> parts = parts_of(part, depth);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const std::span<const Item> items = parts[k].items;
      set_lane(nodes_[place], k, parts[k].hull.low, parts[k].hull.high);
      const std::uint32_t child =
          items.size() == 1 ? BoxNode::kBox | items.front().box : add_node(parts[k], depth + 1);
      nodes_[place].child[k] = child;
    }
    return place;
  }

  std::span<const BoxNode> nodes() const { return nodes_; }

 private:
  // Boxes of a leaf in the order of the map, so that a region finds them nearly sorted.
  static void fill_leaf(BoxNode& node, std::span<Item> items) {
    std::sort(items.begin(), items.end(),
              [](const Item& a, const Item& b) { return a.box < b.box; });
    for (std::size_t k = 0; k < items.size(); ++k) {
      set_lane(node, k, items[k].low, items[k].high);
      node.child[k] = BoxNode::kBox | items[k].box;
    }
  }

  // The part of the largest surface is split until there are sixteen, or only parts that fit a
  // leaf.
  static std::vector<Part> parts_of(const Part& whole, int depth) {
    const bool evenly = depth >= kMostSplitDepth;
    std::vector<Part> out;
    out.reserve(kLanes);
    out.push_back(whole);
    while (out.size() < kLanes) {
      const std::size_t largest = largest_part(out, evenly);
      if (largest == out.size()) break;
      const std::span<Item> items = out[largest].items;
      const std::size_t near = evenly ? items.size() / 2 : split(out[largest]);
      out[largest] = Part(items.first(near));
      out.emplace_back(items.subspan(near));
    }
    return out;
  }

  static std::size_t largest_part(std::span<const Part> parts, bool by_count) {
    std::size_t best = parts.size();
    float most = -1;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const std::size_t count = parts[k].items.size();
      const float size = by_count ? static_cast<float>(count) : parts[k].hull.half_surface();
      if (count <= kLanes || size <= most) continue;
      best = k;
      most = size;
    }
    return best;
  }

  std::vector<BoxNode> nodes_;
};

std::vector<Item> items_of(std::span<const Aabb> boxes, const TreeFrame& frame) {
  std::vector<Item> out;
  out.reserve(boxes.size());
  for (const Aabb& box : boxes) {
    out.push_back({{frame.low(box, 0), frame.low(box, 1), frame.low(box, 2), 0},
                   {frame.high(box, 0), frame.high(box, 1), frame.high(box, 2), 0},
                   static_cast<std::uint32_t>(out.size())});
  }
  return out;
}

}  // namespace

BuiltTree split_tree(std::span<const Aabb> boxes, const TreeFrame& frame) {
  std::vector<Item> items = items_of(boxes, frame);
  Splitter splitter(boxes.size());
  splitter.add_node(Part(items), 0);
  return filled_tree(frame, splitter.nodes(), boxes.size());
}

}  // namespace geom
