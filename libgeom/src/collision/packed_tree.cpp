#include "packed_tree.h"

#include <algorithm>
#include <cmath>

namespace geom {
namespace {

constexpr std::size_t kLanes = BoxNode::kLanes;
constexpr double kMuch = 0.25;        // of the whole, on x or y
constexpr std::size_t kMostWide = 8;  // more are no exception

struct Item {
  float x;  // of the centre
  float y;
  std::uint32_t box;
};

class Packer {
 public:
  Packer(std::span<const Aabb> boxes, BuiltTree& out) : boxes_(boxes), out_(out) {}

  struct Made {
    std::uint32_t node;
    Aabb bounds;
  };

  // A node of all items, each part of which has one child; then `wide`, each a child.
  Made add_node(std::span<Item> items, std::span<const Item> wide) {
    const auto place = static_cast<std::uint32_t>(out_.tree.nodes.size());
    out_.tree.nodes.emplace_back(empty_node());
    Made made{place, boxes_[items.empty() ? wide.front().box : items.front().box]};
    std::size_t k = 0;
    const auto add = [&](std::uint32_t child, const Aabb& box) {
      set(place, k++, child, box);
      made.bounds.min = made.bounds.min.cwiseMin(box.min);
      made.bounds.max = made.bounds.max.cwiseMax(box.max);
    };
    if (items.size() + wide.size() > kLanes) {
      std::size_t each = kLanes;  // items of a part: as many as full nodes hold
      while (each * (kLanes - wide.size()) < items.size()) each *= kLanes;
      const std::size_t parts = parts_of(items.size(), each);
      const auto strips =
          static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(parts))));
      const std::size_t strip_size = each * parts_of(parts, strips);
      tile(items, strip_size, &Item::y, [&](std::span<Item> strip) {
        tile(strip, each, &Item::x, [&](std::span<Item> part) {
          const Made child = add_node(part, {});
          add(child.node, child.bounds);
        });
      });
      items = {};
    }
    for (const Item& item : items) add(leaf(item), boxes_[item.box]);
    for (const Item& item : wide) add(leaf(item), boxes_[item.box]);
    return made;
  }

 private:
  static std::size_t parts_of(std::size_t count, std::size_t each) {
    return (count + each - 1) / each;
  }

  // Calls f for so many items after the other, in the order of their centres.
  template <class F>
  static void tile(std::span<Item> items, std::size_t each, float Item::*centre, const F& f) {
    while (items.size() > each) {
      std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(each),
                       items.end(),
                       [&](const Item& a, const Item& b) { return a.*centre < b.*centre; });
      f(items.first(each));
      items = items.subspan(each);
    }
    f(items);
  }

  std::uint32_t leaf(const Item& item) {
    out_.order.push_back(item.box);
    return BoxNode::kBox | static_cast<std::uint32_t>(out_.order.size() - 1);
  }

  void set(std::uint32_t place, std::size_t k, std::uint32_t child, const Aabb& box) {
    BoxNode& node = out_.tree.nodes[place];
    node.child[k] = child;
    for (int i = 0; i < 3; ++i) {
      node.plane[i][k] = out_.tree.frame.low(box, i);
      node.plane[3 + i][k] = out_.tree.frame.high(box, i);
    }
  }

  std::span<const Aabb> boxes_;
  BuiltTree& out_;
};

bool is_wide(const Aabb& box, const Vec3& whole) {
  const Vec3 size = box.max - box.min;
  return size.x() > kMuch * whole.x() || size.y() > kMuch * whole.y();
}

}  // namespace

BuiltTree packed_tree(std::span<const Aabb> boxes) {
  const Aabb all = *bounds(boxes);
  std::vector<Item> items;
  items.reserve(boxes.size());
  for (const Aabb& box : boxes) {
    const Eigen::Vector2f centre = (0.5 * (box.min + box.max) - all.min).head<2>().cast<float>();
    items.push_back({centre.x(), centre.y(), static_cast<std::uint32_t>(items.size())});
  }
  auto wide = std::partition(items.begin(), items.end(), [&](const Item& item) {
    return !is_wide(boxes[item.box], all.max - all.min);
  });
  if (items.end() - wide > static_cast<std::ptrdiff_t>(kMostWide)) wide = items.end();
  BuiltTree out{{TreeFrame(all), {}}, {}};
  out.order.reserve(boxes.size());
  out.tree.nodes.reserve(boxes.size() / 8 + kLanes);
  Packer(boxes, out).add_node({items.begin(), wide}, {wide, items.end()});
  return out;
}

}  // namespace geom
