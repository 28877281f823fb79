#include "traj/home/prism.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace traj {
namespace {

using geom::Aabb;

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

constexpr double kRounding = 16 * std::numeric_limits<double>::epsilon();

double size_of(const Vec2& p) { return std::abs(p.x()) + std::abs(p.y()); }

double distance_to_edge(const Vec2& a, const Vec2& b, const Vec2& p) {
  const Vec2 way = b - a;
  const double squared = way.squaredNorm();
  const double s = squared > 0 ? std::clamp((p - a).dot(way) / squared, 0.0, 1.0) : 0;
  return (a + s * way - p).norm();
}

}  // namespace

std::vector<Vec2> plan_hull(std::vector<Vec2> points) {
  const auto before = [](const Vec2& a, const Vec2& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Vec2> hull;
  const auto add = [&](const Vec2& p, std::size_t least) {
    while (hull.size() >= least + 2 &&
           cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0) {
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const Vec2& p : points) add(p, 0);
  const std::size_t lower = hull.size() - 1;
  for (auto p = points.rbegin() + 1; p != points.rend(); ++p) add(*p, lower);
  hull.pop_back();
  return hull;
}

namespace {

// Ways of edges counterclockwise, from straight down on: a convex plan begins at its corner
// furthest to the left.
bool turns_before(const Vec2& a, const Vec2& b) {
  const auto goes_left = [](const Vec2& way) {
    return way.x() < 0 || (way.x() == 0 && way.y() < 0);
  };
  if (goes_left(a) != goes_left(b)) return goes_left(b);
  return cross(a, b) > 0;
}

std::vector<Vec2> edges(const std::vector<Vec2>& plan) {
  std::vector<Vec2> out;
  if (plan.size() < 2) return out;
  out.reserve(plan.size());
  for (std::size_t i = 1; i < plan.size(); ++i) out.push_back(plan[i] - plan[i - 1]);
  out.push_back(plan.front() - plan.back());
  return out;
}

}  // namespace

// Edges of both, in the order of their ways, are those of the sum. By rounding it may have edges
// that are too short to have a way: plan_hull() takes them out.
std::vector<Vec2> plan_sum(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  const std::vector<Vec2> of_a = edges(a);
  const std::vector<Vec2> of_b = edges(b);
  std::vector<Vec2> out;
  out.reserve(of_a.size() + of_b.size() + 1);
  std::size_t i = 0;
  std::size_t k = 0;
  while (i < of_a.size() || k < of_b.size()) {
    out.push_back(a[i % a.size()] + b[k % b.size()]);
    const bool only_a = k == of_b.size();
    const bool only_b = i == of_a.size();
    const bool next_a = only_a || (!only_b && !turns_before(of_b[k], of_a[i]));
    const bool next_b = only_b || (!only_a && !turns_before(of_a[i], of_b[k]));
    i += next_a;
    k += next_b;
  }
  if (out.empty()) out.push_back(a.front() + b.front());
  return plan_hull(std::move(out));
}

Prism prism_around(std::span<const Vec3> points) {
  Prism out{{}, points.front().z(), points.front().z()};
  for (const Vec3& p : points) {
    out.plan.push_back(p.head<2>());
    out.low = std::min(out.low, p.z());
    out.high = std::max(out.high, p.z());
  }
  out.plan = plan_hull(std::move(out.plan));
  return out;
}

std::vector<Vec3> corners(const Prism& prism) {
  std::vector<Vec3> out;
  for (const double z : {prism.low, prism.high}) {
    for (const Vec2& p : prism.plan) out.emplace_back(p.x(), p.y(), z);
  }
  return out;
}

bool meets(const Prism& prism, const Aabb& box) { return PrismMeeting(prism).with(box); }

PrismMeeting::PrismMeeting(const Prism& prism) {
  const std::vector<Vec2>& plan = prism.plan;
  bounds_ = {{plan.front().x(), plan.front().y(), prism.low},
             {plan.front().x(), plan.front().y(), prism.high}};
  edges_.reserve(plan.size());
  for (std::size_t i = 0; i < plan.size(); ++i) {
    const Vec2& a = plan[i];
    const Vec2& b = plan[(i + 1) % plan.size()];
    bounds_.min.head<2>() = bounds_.min.head<2>().cwiseMin(a);
    bounds_.max.head<2>() = bounds_.max.head<2>().cwiseMax(a);
    if (plan.size() < 2) continue;
    const Vec2 out(b.y() - a.y(), a.x() - b.x());
    edges_.push_back({a, out, out.cwiseAbs(), kRounding * size_of(out), size_of(a) + size_of(b)});
  }
}

// The plan is to the left of its edges. In coordinates from an edge's begin: differences, products
// and sums round by less than 16 units of the largest.
bool PrismMeeting::with(const Aabb& box) const {
  if ((bounds_.min.array() > box.max.array()).any()) return false;
  if ((bounds_.max.array() < box.min.array()).any()) return false;
  const Vec2 middle = 0.5 * (box.min + box.max).head<2>();
  const Vec2 half = (box.max.head<2>() - middle).cwiseMax(middle - box.min.head<2>());
  const double size = size_of(middle) + size_of(half);
  for (const Edge& edge : edges_) {
    const double away = edge.out.dot(middle - edge.begin);
    const double reach = half.dot(edge.out_sizes);
    if (away - reach > edge.rounding * (edge.size + size)) return false;
  }
  return true;
}

// A part holds the corners between its ends, and where sides cross these.
std::vector<Aabb> boxes_around(const Prism& prism, int parts) {
  const Aabb whole = PrismMeeting(prism).bounds();
  const Vec2 size = (whole.max - whole.min).head<2>();
  const int along = size.x() >= size.y() ? 0 : 1;
  const int across = 1 - along;
  std::vector<Aabb> out;
  for (int k = 0; k < parts; ++k) {
    const double from = whole.min[along] + size[along] * k / parts;
    const double until =
        k + 1 == parts ? whole.max[along] : whole.min[along] + size[along] * (k + 1) / parts;
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (std::size_t i = 0; i < prism.plan.size(); ++i) {
      const Vec2& a = prism.plan[i];
      const Vec2& b = prism.plan[(i + 1) % prism.plan.size()];
      const double low = std::max(from, std::min(a[along], b[along]));
      const double high = std::min(until, std::max(a[along], b[along]));
      if (low > high) continue;
      for (const double at : {low, high}) {
        const double way = b[along] - a[along];
        const double share = way != 0 ? std::clamp((at - a[along]) / way, 0.0, 1.0) : 0;
        const double there = a[across] + share * (b[across] - a[across]);
        least = std::min(least, way != 0 ? there : std::min(a[across], b[across]));
        most = std::max(most, way != 0 ? there : std::max(a[across], b[across]));
      }
    }
    if (least > most) continue;
    Aabb box = whole;
    box.min[along] = from, box.max[along] = until;
    box.min[across] = least, box.max[across] = most;
    out.push_back(box);
  }
  return out;
}

double distance(const std::vector<Vec2>& plan, const Vec2& p) {
  double least = std::numeric_limits<double>::infinity();
  bool inside = plan.size() > 2;
  for (std::size_t i = 0; i < plan.size(); ++i) {
    const Vec2& a = plan[i];
    const Vec2& b = plan[(i + 1) % plan.size()];
    least = std::min(least, distance_to_edge(a, b, p));
    inside = inside && cross(b - a, p - a) >= 0;
  }
  return inside ? 0 : least;
}

double furthest(const std::vector<Vec2>& plan, const Vec2& p) {
  double most = 0;
  for (const Vec2& q : plan) most = std::max(most, (q - p).norm());
  return most;
}

}  // namespace traj
