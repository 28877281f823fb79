#include "few_corners.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <queue>
#include <tuple>

namespace traj {
namespace {

constexpr int kBuckets = 48;             // along each axis
constexpr double kDepth = 1e-6;          // m
constexpr double kApart = 1e-3;          // m between edges, so that rounding crosses none
constexpr std::size_t kMostTried = 120;  // corners of a ring for which many places are tried

double turn(const Vec2& a, const Vec2& b, const Vec2& c) { return cross(b - a, c - a); }

// From a point to a segment, m.
double distance(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 way = b - a;
  const double length = way.squaredNorm();
  const double at = length > 0 ? std::clamp((p - a).dot(way) / length, 0.0, 1.0) : 0;
  return (p - a - at * way).norm();
}

// Whether two segments come nearer to each other than kApart.
bool near(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const PlanBox ab = box_around({a, b});
  if (!overlap(grown(ab, kApart), box_around({c, d}))) return false;
  const bool crosses =
      (turn(a, b, c) > 0) != (turn(a, b, d) > 0) && (turn(c, d, a) > 0) != (turn(c, d, b) > 0);
  return crosses || std::min({distance(a, c, d), distance(b, c, d), distance(c, a, b),
                              distance(d, a, b)}) < kApart;
}

// A number that looks random, from 0.2 to 5, of a seed and a corner; 1 for the seed 0.
double weight(std::uint64_t seed, std::size_t corner) {
  if (seed == 0) return 1;
  std::uint64_t x = seed * 0x9e3779b97f4a7c15u + corner * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return 0.2 * std::pow(25, static_cast<double>((x ^ (x >> 31)) >> 11) * 0x1p-53);
}

class Ring {
 public:
  Ring(const std::vector<Vec2>& corners, const Kept& kept, std::uint64_t seed)
      : kept_(kept), seed_(seed), count_(corners.size()) {
    for (std::size_t i = 0; i < count_; ++i) {
      nodes_.push_back({corners[i], (i + count_ - 1) % count_, (i + 1) % count_});
    }
  }

  void reduce() {
    do {
      drop_all();
    } while (join_one());
  }

  std::vector<Vec2> corners() const {
    std::vector<Vec2> out;
    for (const Node& node : nodes_) {
      if (node.there) out.push_back(node.at);
    }
    return out;
  }

 private:
  struct Node {
    Vec2 at;
    std::size_t before;
    std::size_t after;
    unsigned changes = 0;
    bool there = true;
  };
  // Cost, corner, and how often the corner had changed.
  using Candidate = std::tuple<double, std::size_t, unsigned>;

  // Another corner for two: least cost first.
  struct Joint {
    double cost;
    std::size_t first;
    Vec2 at;
  };

  const Vec2& at(std::size_t i) const { return nodes_[i].at; }

  Candidate candidate(std::size_t i) const {
    const Node& node = nodes_[i];
    const double area = std::abs(turn(at(node.before), node.at, at(node.after)));
    return {area * weight(seed_, i), i, node.changes};
  }

  // Corners that may go one by one, until none may.
  void drop_all() {
    for (bool changed = true; changed;) {
      changed = false;
      std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue;
      for (std::size_t i = 0; i < nodes_.size(); ++i) {
        if (nodes_[i].there) queue.push(candidate(i));
      }
      for (; !queue.empty() && count_ > 3; queue.pop()) {
        const auto [cost, i, changes] = queue.top();
        if (!nodes_[i].there || nodes_[i].changes != changes || !may_drop(i)) continue;
        const std::size_t before = nodes_[i].before;
        const std::size_t after = nodes_[i].after;
        drop(i);
        changed = true;
        queue.push(candidate(before));
        queue.push(candidate(after));
      }
    }
  }

  bool may_drop(std::size_t i) const {
    const Node& node = nodes_[i];
    return kept_.clear(at(node.before), node.at, at(node.after)) &&
           is_simple_with(at(node.before), at(node.after), {node.before, i, node.after});
  }

  void drop(std::size_t i) {
    Node& node = nodes_[i];
    node.there = false;
    nodes_[node.before].after = node.after;
    nodes_[node.after].before = node.before;
    ++nodes_[node.before].changes;
    ++nodes_[node.after].changes;
    --count_;
  }

  // Whether a new edge keeps away from all edges but those at the corners that are left out, and
  // does not run back along one of its neighbours.
  bool is_simple_with(const Vec2& a, const Vec2& b,
                      std::initializer_list<std::size_t> left_out) const {
    const auto out = [&](std::size_t i) {
      return std::find(left_out.begin(), left_out.end(), i) != left_out.end();
    };
    if ((b - a).norm() < 10 * kApart) return false;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const Node& node = nodes_[i];
      if (!node.there) continue;
      const bool first = out(i);
      const bool second = out(node.after);
      if (first && second) continue;
      const Vec2& c = node.at;
      const Vec2& d = at(node.after);
      if (!first && !second && near(a, b, c, d)) return false;
      if (first && distance(d, a, b) < kApart) return false;
      if (second && distance(c, a, b) < kApart) return false;
      if (first != second && is_spike(a, b, c, d)) return false;
    }
    return true;
  }

  // Whether an edge that begins or ends where c, d does runs back along it.
  static bool is_spike(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    for (const Vec2& p : {a, b}) {
      for (const Vec2& q : {c, d}) {
        if (p != q) continue;
        const Vec2 one = (p == a ? b : a) - p;
        const Vec2 other = (q == c ? d : c) - q;
        const double sine = std::abs(cross(one, other)) / (one.norm() * other.norm());
        if (one.dot(other) > 0 && sine < 1e-4) return true;
      }
    }
    return false;
  }

  // Puts the two neighbours that cost least into one; false where none may be.
  bool join_one() {
    if (count_ <= 3) return false;
    std::vector<Joint> joints;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      if (nodes_[i].there) add_joints(i, joints);
    }
    std::stable_sort(joints.begin(), joints.end(),
                     [](const Joint& a, const Joint& b) { return a.cost < b.cost; });
    for (const Joint& joint : joints) {
      if (!may_join(joint)) continue;
      const std::size_t second = nodes_[joint.first].after;
      nodes_[joint.first].at = joint.at;
      drop(second);
      return true;
    }
    return false;
  }

  // Places for a corner and the next: where the edges beside them meet, and beside the middle.
  void add_joints(std::size_t i, std::vector<Joint>& joints) const {
    const Node& node = nodes_[i];
    const Vec2& a = at(node.before);
    const Vec2& b = node.at;
    const Vec2& c = at(node.after);
    const Vec2& d = at(nodes_[node.after].after);
    const auto add = [&](const Vec2& p) {
      if (!kept_.within_bounds(p)) return;
      const double area =
          std::abs(turn(a, b, p)) + std::abs(turn(b, c, p)) + std::abs(turn(c, d, p));
      joints.push_back({area * weight(seed_, i), i, p});
    };
    if (const auto meeting = ahead(a, b, d, c)) add(*meeting);
    const Vec2 way = c - b;
    const Vec2 across = Vec2(way.y(), -way.x()).normalized();
    if (count_ > kMostTried) return;
    for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
      for (const double off : {0.0, 0.05, 0.2, 1.0, 4.0, 12.0}) {
        add(b + share * way + off * across);
        if (off > 0) add(b + share * way - off * across);
      }
    }
  }

  // Where the ways from a through b and from d through c meet, ahead of b and c.
  static std::optional<Vec2> ahead(const Vec2& a, const Vec2& b, const Vec2& d, const Vec2& c) {
    const Vec2 one = b - a;
    const Vec2 other = c - d;
    const double sine = cross(one, other);
    if (std::abs(sine) < 1e-9 * one.norm() * other.norm()) return std::nullopt;
    const double along = cross(d - a, other) / sine;
    const double back = cross(d - a, one) / sine;
    if (along < 1 || back < 1) return std::nullopt;
    return Vec2(a + along * one);
  }

  bool may_join(const Joint& joint) const {
    const std::size_t before = nodes_[joint.first].before;
    const std::size_t second = nodes_[joint.first].after;
    const std::size_t after = nodes_[second].after;
    if (before == after) return false;
    const auto left_out = {before, joint.first, second, after};
    const Vec2& p = joint.at;
    return kept_.clear(at(before), at(joint.first), p) &&
           kept_.clear(at(joint.first), at(second), p) && kept_.clear(at(second), at(after), p) &&
           !is_spike(at(before), p, p, at(after)) && is_simple_with(at(before), p, left_out) &&
           is_simple_with(p, at(after), left_out);
  }

  const Kept& kept_;
  std::uint64_t seed_;
  std::size_t count_;
  std::vector<Node> nodes_;
};

}  // namespace

Kept::Kept(std::vector<Outline> shapes, const PlanBox& bounds)
    : shapes_(std::move(shapes)),
      bounds_(bounds),
      step_((bounds.max - bounds.min).cwiseMax(1e-3) / kBuckets),
      buckets_(kBuckets * kBuckets) {
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    boxes_.push_back(box_around(shapes_[i]));
    const Range range = range_of(boxes_.back());
    for (int y = range.from[1]; y <= range.to[1]; ++y) {
      for (int x = range.from[0]; x <= range.to[0]; ++x) buckets_[y * kBuckets + x].push_back(i);
    }
  }
}

Kept::Range Kept::range_of(const PlanBox& box) const {
  Range range;
  for (int axis = 0; axis < 2; ++axis) {
    const auto bucket = [&](double at) {
      const double share = std::floor((at - bounds_.min(axis)) / step_(axis));
      return static_cast<int>(std::clamp(share, 0.0, kBuckets - 1.0));
    };
    range.from[axis] = bucket(box.min(axis) - kDepth);
    range.to[axis] = bucket(box.max(axis) + kDepth);
  }
  return range;
}

bool Kept::within_bounds(const Vec2& p) const { return overlap({p, p}, bounds_); }

bool Kept::clear(const Vec2& a, const Vec2& b, const Vec2& c) const {
  const Outline triangle{a, b, c};
  const PlanBox box = box_around(triangle);
  const Range range = range_of(box);
  for (int y = range.from[1]; y <= range.to[1]; ++y) {
    for (int x = range.from[0]; x <= range.to[0]; ++x) {
      for (const std::size_t i : buckets_[y * kBuckets + x]) {
        if (overlap(box, boxes_[i]) && meet(shapes_[i], triangle, kDepth)) return false;
      }
    }
  }
  return true;
}

bool is_apart(const std::vector<Vec2>& ring) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2& a = ring[i];
    const Vec2& b = ring[(i + 1) % n];
    const Vec2& c = ring[(i + 2) % n];
    if ((b - a).norm() < kApart || distance(c, a, b) < kApart || distance(a, b, c) < kApart) {
      return false;
    }
    for (std::size_t k = i + 2; k < n; ++k) {
      if ((k + 1) % n != i && near(a, b, ring[k], ring[(k + 1) % n])) return false;
    }
  }
  return n >= 3;
}

std::vector<Vec2> few_corners(const std::vector<Vec2>& ring, const Kept& kept, std::uint64_t seed) {
  Ring out(ring, kept, seed);
  out.reduce();
  return out.corners();
}

}  // namespace traj
