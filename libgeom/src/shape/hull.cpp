#include "geom/shape/hull.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "geom/base/precondition.h"

namespace geom {
namespace {

constexpr int kMostSteps = 100;  // Wolfe's method ends by itself in far fewer
constexpr double kRounding = 1e-15;

// Whether the plane across `n` has all points strictly on one side and the box on the other,
// whatever rounding did: three products and two sums are off by less than 4 units of their size.
bool separates(const Vec3& n, std::span<const Vec3> points, const Aabb& box) {
  double lowest = std::numeric_limits<double>::infinity();
  double size = 0;
  for (const Vec3& p : points) {
    lowest = std::min(lowest, n.dot(p));
    size = std::max(size, n.cwiseAbs().dot(p.cwiseAbs()));
  }
  double highest = 0;
  for (int i = 0; i < 3; ++i) {
    highest += std::max(n[i] * box.min[i], n[i] * box.max[i]);
    size += std::abs(n[i]) * std::max(std::abs(box.min[i]), std::abs(box.max[i]));
  }
  return lowest - highest > kRounding * size;
}

// A difference of a point and a corner, and which point.
struct Vertex {
  Vec3 difference;
  std::size_t point = 0;
};

// The point of least norm of the hull of all differences.
class NearestDifference {
 public:
  NearestDifference(std::span<const Vec3> points, const Aabb& box) : points_(points), box_(box) {}

  // A point of the hull that is in the box, as far as can be told; nothing where they are apart.
  std::optional<Vec3> meeting() {
    corral_ = {vertex_along(points_.front() - 0.5 * (box_.min + box_.max))};
    set_weights(Eigen::VectorXd::Ones(1));
    for (int step = 0; step < kMostSteps; ++step) {
      const Vec3 x = nearest();
      if (separates(x, points_, box_)) return std::nullopt;
      const Vertex next = vertex_along(x);
      if (x.dot(next.difference) >= x.squaredNorm() * (1 - 1e-12) || known(next)) break;
      corral_.push_back(next);
      weights_.conservativeResize(weights_.size() + 1);
      weights_[weights_.size() - 1] = 0;
      settle();
    }
    Vec3 place = Vec3::Zero();
    for (std::size_t i = 0; i < corral_.size(); ++i) {
      place += weights_[static_cast<Eigen::Index>(i)] * points_[corral_[i].point];
    }
    return place;
  }

 private:
  // Where the size differs, Eigen's own assignment frees the old weights before it has room for the
  // new ones: if there is none, they would be freed once more.
  void set_weights(Eigen::VectorXd weights) { weights_.swap(weights); }

  // The difference that reaches furthest against `n`.
  Vertex vertex_along(const Vec3& n) const {
    std::size_t lowest = 0;
    for (std::size_t i = 1; i < points_.size(); ++i) {
      if (n.dot(points_[i]) < n.dot(points_[lowest])) lowest = i;
    }
    Vec3 corner;
    for (int i = 0; i < 3; ++i) corner[i] = n[i] > 0 ? box_.max[i] : box_.min[i];
    return {points_[lowest] - corner, lowest};
  }

  bool known(const Vertex& vertex) const {
    return std::any_of(corral_.begin(), corral_.end(),
                       [&](const Vertex& v) { return v.difference == vertex.difference; });
  }

  Vec3 nearest() const {
    Vec3 x = Vec3::Zero();
    for (std::size_t i = 0; i < corral_.size(); ++i) {
      x += weights_[static_cast<Eigen::Index>(i)] * corral_[i].difference;
    }
    return x;
  }

  // Weights, of sum 1, of the point nearest to zero of the plane through the corral.
  Eigen::VectorXd affine_weights() const {
    const auto n = static_cast<Eigen::Index>(corral_.size());
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + 1, n + 1);
    for (Eigen::Index i = 0; i < n; ++i) {
      for (Eigen::Index j = 0; j < n; ++j) {
        system(i + 1, j + 1) = corral_[static_cast<std::size_t>(i)].difference.dot(
            corral_[static_cast<std::size_t>(j)].difference);
      }
      system(0, i + 1) = system(i + 1, 0) = 1;
    }
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n + 1);
    right[0] = 1;
    return system.fullPivLu().solve(right).tail(n);
  }

  // Wolfe's minor cycle: goes towards the nearest point of the plane, and drops what it leaves.
  void settle() {
    while (corral_.size() > 1) {
      const Eigen::VectorXd wanted = affine_weights();
      double share = 1;
      for (Eigen::Index i = 0; i < wanted.size(); ++i) {
        if (wanted[i] < 0) share = std::min(share, weights_[i] / (weights_[i] - wanted[i]));
      }
      weights_ += share * (wanted - weights_);
      if (share == 1) return;
      drop_least();
    }
    set_weights(Eigen::VectorXd::Ones(1));
  }

  void drop_least() {
    Eigen::Index least = 0;
    weights_.minCoeff(&least);
    corral_.erase(corral_.begin() + least);
    std::vector<double> kept(weights_.begin(), weights_.end());
    kept.erase(kept.begin() + least);
    set_weights(Eigen::Map<Eigen::VectorXd>(kept.data(), static_cast<Eigen::Index>(kept.size())));
    weights_ = weights_.cwiseMax(0) / weights_.cwiseMax(0).sum();
  }

  std::span<const Vec3> points_;
  const Aabb& box_;
  std::vector<Vertex> corral_;
  Eigen::VectorXd weights_;
};

void require(std::span<const Vec3> points, const Aabb& box) {
  for (const Vec3& p : points) require_point("hull", p);
  require_point("box", box.min);
  require_point("box", box.max);
}

}  // namespace

std::optional<Vec3> hull_meets(std::span<const Vec3> points, const Aabb& box) {
  require(points, box);
  for (int i = 0; i < 3; ++i) {
    if (separates(Vec3::Unit(i), points, box) || separates(-Vec3::Unit(i), points, box)) {
      return std::nullopt;
    }
  }
  return NearestDifference(points, box).meeting();
}

HullDepth hull_depth(std::span<const Vec3> points, const Aabb& box) {
  constexpr double kEnough = 1e-7;
  HullDepth deepest{0, points.front()};
  if (const auto place = hull_meets(points, box)) deepest.place = *place;
  double apart = 0.5 * (box.max - box.min).minCoeff();
  while (apart - deepest.depth > kEnough) {
    const double depth = 0.5 * (apart + deepest.depth);
    const Vec3 by = Vec3::Constant(depth);
    const auto place = hull_meets(points, {box.min + by, box.max - by});
    if (place) deepest = {depth, *place};
    if (!place) apart = depth;
  }
  return deepest;
}

}  // namespace geom
