#include "filled_tree.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace geom {
namespace {

// A tree without one of its boxes would call it free.
void require_each_box(std::span<const std::uint32_t> order, std::size_t boxes) {
  std::vector<bool> seen(boxes);
  for (const std::uint32_t box : order) seen[box] = true;
  if (order.size() != boxes || std::find(seen.begin(), seen.end(), false) != seen.end()) {
    throw std::logic_error("a collision tree has not each of its boxes once");
  }
}

// Children of one node: gathered from a node that was built and from those below it.
class Gathered {
 public:
  explicit Gathered(const BoxNode& node) {
    for (std::size_t k = 0; k < BoxNode::kLanes; ++k) add(node, k);
  }

  // Takes the children of the largest child whose children still fit, in its place. Each node that
  // goes away is one that no question looks at.
  bool open_one(std::span<const BoxNode> nodes) {
    std::size_t best = count_;
    float most = -1;
    for (std::size_t k = 0; k < count_; ++k) {
      const std::uint32_t child = node_.child[k];
      if ((child & BoxNode::kBox) != 0) continue;
      if (count_ - 1 + children(nodes[child]) > BoxNode::kLanes || half_surface(k) <= most)
        continue;
      best = k;
      most = half_surface(k);
    }
    if (best == count_) return false;
    const BoxNode& opened = nodes[node_.child[best]];
    --count_;
    move(count_, best);
    for (std::size_t k = 0; k < BoxNode::kLanes; ++k) add(opened, k);
    return true;
  }

  const BoxNode& node() const { return node_; }

 private:
  static std::size_t children(const BoxNode& node) {
    return static_cast<std::size_t>(
        std::count_if(node.child, node.child + BoxNode::kLanes,
                      [](std::uint32_t child) { return child != BoxNode::kNone; }));
  }

  void add(const BoxNode& from, std::size_t k) {
    if (from.child[k] == BoxNode::kNone) return;
    for (int i = 0; i < 6; ++i) node_.plane[i][count_] = from.plane[i][k];
    node_.child[count_++] = from.child[k];
  }

  void move(std::size_t from, std::size_t to) {
    for (auto& plane : node_.plane) plane[to] = plane[from];
    node_.child[to] = node_.child[from];
    set_none(from);
  }

  float half_surface(std::size_t k) const {
    const auto side = [&](int i) { return node_.plane[3 + i][k] - node_.plane[i][k]; };
    return side(0) * side(1) + side(1) * side(2) + side(2) * side(0);
  }

  void set_none(std::size_t k) {
    const BoxNode none = empty_node();
    for (int i = 0; i < 6; ++i) node_.plane[i][k] = none.plane[i][k];
    node_.child[k] = BoxNode::kNone;
  }

  BoxNode node_ = empty_node();
  std::size_t count_ = 0;
};

// Lays out the nodes below one, each before its children, and names the boxes anew, from leaf to
// leaf.
void lay_out(std::span<const BoxNode> nodes, std::uint32_t from, BuiltTree& out) {
  Gathered gathered(nodes[from]);
  while (gathered.open_one(nodes)) {
  }
  const std::size_t place = out.tree.nodes.size();
  out.tree.nodes.push_back(gathered.node());
  for (std::size_t k = 0; k < BoxNode::kLanes; ++k) {
    const std::uint32_t child = gathered.node().child[k];
    if (child == BoxNode::kNone || (child & BoxNode::kBox) == 0) continue;
    out.order.push_back(child & ~BoxNode::kBox);
    out.tree.nodes[place].child[k] =
        BoxNode::kBox | static_cast<std::uint32_t>(out.order.size() - 1);
  }
  for (std::size_t k = 0; k < BoxNode::kLanes; ++k) {
    const std::uint32_t child = gathered.node().child[k];
    if ((child & BoxNode::kBox) != 0) continue;
    out.tree.nodes[place].child[k] = static_cast<std::uint32_t>(out.tree.nodes.size());
    lay_out(nodes, child, out);
  }
}

}  // namespace

BuiltTree filled_tree(const TreeFrame& frame, std::span<const BoxNode> nodes, std::size_t boxes) {
  BuiltTree out{{frame, {}}, {}};
  out.tree.nodes.reserve(nodes.size());
  out.order.reserve(boxes);
  lay_out(nodes, 0, out);
  require_each_box(out.order, boxes);
  return out;
}

}  // namespace geom
