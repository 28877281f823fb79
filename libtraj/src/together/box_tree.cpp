#include "box_tree.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geom/base/parallel.h"

namespace traj {
namespace {

constexpr std::size_t kLeaf = 8;
constexpr std::size_t kTasks = 4096;   // pairs of nodes that threads share
constexpr double kMetresASecond = 10;  // how long a second is where a node is cut

struct Node {
  TimedBox box;
  std::size_t first = 0;  // of the boxes
  std::size_t count = 0;
  std::size_t left = 0;  // 0: a leaf
  std::size_t right = 0;
};

struct NodePair {
  std::size_t a;
  std::size_t b;
};

TimedBox merged(TimedBox a, const TimedBox& b) {
  for (std::size_t i = 0; i < 4; ++i) {
    a.low[i] = std::min(a.low[i], b.low[i]);
    a.high[i] = std::max(a.high[i], b.high[i]);
  }
  return a;
}

bool lasts_for_ever(const TimedBox& box) {
  return !std::isfinite(box.low[3]) || !std::isfinite(box.high[3]);
}

class Tree {
 public:
  explicit Tree(std::vector<TimedBox> boxes) : boxes_(std::move(boxes)) {
    const auto split = std::stable_partition(boxes_.begin(), boxes_.end(), lasts_for_ever);
    const auto parked = static_cast<std::size_t>(split - boxes_.begin());
    nodes_.reserve(boxes_.size() / 2 + 8);
    add_root(0, parked);
    add_root(parked, boxes_.size() - parked);
  }

  std::vector<FlightPair> pairs(const geom::Execution& run) const {
    const std::vector<NodePair> tasks = shared();
    std::vector<std::vector<FlightPair>> found(tasks.size());
    geom::parallel_for(tasks.size(), run, [&](std::size_t i) {
      descend(tasks[i], found[i]);
      tidy(found[i]);
    });
    std::vector<FlightPair> out;
    for (const auto& part : found) out.insert(out.end(), part.begin(), part.end());
    tidy(out);
    return out;
  }

 private:
  static void tidy(std::vector<FlightPair>& pairs) {
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  }

  void add_root(std::size_t first, std::size_t count) {
    if (count > 0) roots_.push_back(build(first, count));
  }

  std::size_t build(std::size_t first, std::size_t count) {
    const std::size_t at = nodes_.size();
    Node node{boxes_[first], first, count};
    for (std::size_t i = 1; i < count; ++i) node.box = merged(node.box, boxes_[first + i]);
    nodes_.push_back(node);
    if (count <= kLeaf) return at;
    const std::size_t half = cut(first, count);
    const std::size_t left = build(first, half);
    const std::size_t right = build(first + half, count - half);
    nodes_[at].left = left;
    nodes_[at].right = right;
    return at;
  }

  // Where a box is along an axis, for the cut alone.
  static double middle(const TimedBox& box, std::size_t axis) {
    const double low = box.low[axis];
    const double high = box.high[axis];
    if (!std::isfinite(low)) return std::isfinite(high) ? high : 0;
    return std::isfinite(high) ? 0.5 * low + 0.5 * high : low;
  }

  // Puts the boxes in two halves along the axis in which their middles are furthest apart.
  std::size_t cut(std::size_t first, std::size_t count) {
    std::array<double, 4> low{};
    std::array<double, 4> high{};
    for (std::size_t axis = 0; axis < 4; ++axis) {
      low[axis] = high[axis] = middle(boxes_[first], axis);
      for (std::size_t i = 1; i < count; ++i) {
        low[axis] = std::min(low[axis], middle(boxes_[first + i], axis));
        high[axis] = std::max(high[axis], middle(boxes_[first + i], axis));
      }
    }
    std::size_t longest = 0;
    double most = -1;
    for (std::size_t axis = 0; axis < 4; ++axis) {
      const double length = (high[axis] - low[axis]) * (axis == 3 ? kMetresASecond : 1);
      if (length > most) {
        most = length;
        longest = axis;
      }
    }
    const auto begin = boxes_.begin() + static_cast<std::ptrdiff_t>(first);
    const auto half = static_cast<std::ptrdiff_t>(count / 2);
    std::nth_element(begin, begin + half, begin + static_cast<std::ptrdiff_t>(count),
                     [longest](const TimedBox& a, const TimedBox& b) {
                       return middle(a, longest) < middle(b, longest);
                     });
    return count / 2;
  }

  // The pairs of nodes below one pair that meet.
  void below(const NodePair& pair, std::vector<NodePair>& out) const {
    const Node& a = nodes_[pair.a];
    const Node& b = nodes_[pair.b];
    const auto add = [&](std::size_t i, std::size_t k) {
      if (i == k || meet(nodes_[i].box, nodes_[k].box)) out.push_back({i, k});
    };
    if (pair.a == pair.b) {
      add(a.left, a.left);
      add(a.left, a.right);
      add(a.right, a.right);
    } else if (b.left == 0 || (a.left != 0 && a.count >= b.count)) {
      add(a.left, pair.b);
      add(a.right, pair.b);
    } else {
      add(pair.a, b.left);
      add(pair.a, b.right);
    }
  }

  bool is_end(const NodePair& pair) const {
    return nodes_[pair.a].left == 0 && nodes_[pair.b].left == 0;
  }

  // Pairs of nodes that hold all pairs of boxes that meet, enough for all threads.
  std::vector<NodePair> shared() const {
    std::vector<NodePair> tasks;
    for (std::size_t i = 0; i < roots_.size(); ++i) {
      for (std::size_t k = i; k < roots_.size(); ++k) tasks.push_back({roots_[i], roots_[k]});
    }
    for (bool cut = true; cut && tasks.size() < kTasks;) {
      cut = false;
      std::vector<NodePair> next;
      for (const NodePair& pair : tasks) {
        if (is_end(pair)) {
          next.push_back(pair);
        } else {
          below(pair, next);
          cut = true;
        }
      }
      tasks = std::move(next);
    }
    return tasks;
  }

  void descend(const NodePair& from, std::vector<FlightPair>& out) const {
    std::vector<NodePair> open{from};
    while (!open.empty()) {
      const NodePair pair = open.back();
      open.pop_back();
      if (!is_end(pair)) {
        below(pair, open);
        continue;
      }
      compare(nodes_[pair.a], nodes_[pair.b], pair.a == pair.b, out);
    }
  }

  void compare(const Node& a, const Node& b, bool same, std::vector<FlightPair>& out) const {
    for (std::size_t i = 0; i < a.count; ++i) {
      const TimedBox& one = boxes_[a.first + i];
      for (std::size_t k = same ? i + 1 : 0; k < b.count; ++k) {
        const TimedBox& other = boxes_[b.first + k];
        if (one.flight == other.flight || !meet(one, other)) continue;
        const FlightPair pair = std::minmax(one.flight, other.flight);
        if (out.empty() || out.back() != pair) out.push_back(pair);
      }
    }
  }

  std::vector<TimedBox> boxes_;
  std::vector<Node> nodes_;
  std::vector<std::size_t> roots_;
};

}  // namespace

bool meet(const TimedBox& a, const TimedBox& b) {
  for (std::size_t i = 0; i < 4; ++i) {
    if (!(a.low[i] <= b.high[i] && b.low[i] <= a.high[i])) return false;
  }
  return true;
}

std::vector<FlightPair> meeting_flights(std::vector<TimedBox> boxes, const geom::Execution& run) {
  if (boxes.empty()) return {};
  return Tree(std::move(boxes)).pairs(run);
}

}  // namespace traj
