#include "shape/ring_stack.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "geom/base/error.h"

namespace geom {
namespace {

// A body by its distance and by points on and in it, about (0, 0, 0).
struct Body {
  const char* name;
  std::function<double(const Vec3&)> distance;
  RingStack stack;
};

double to_box(const Vec3& p, const Vec3& half) {
  return (p.cwiseAbs() - half).cwiseMax(0.0).norm();
}

std::vector<Body> bodies(double error) {
  const auto along = [](const Vec3& p) { return std::hypot(p.x(), p.y()); };
  return {
      {"box",
       [](const Vec3& p) {
         return to_box(p, {2, 1, 0.5});
       },
       box_stack({4, 2, 1})},
      {"board",
       [](const Vec3& p) {
         return to_box(p, {2, 0, 0.5});
       },
       box_stack({4, 0, 1})},
      {"cylinder",
       [=](const Vec3& p) {
         return std::hypot(std::max(0.0, along(p) - 1.5), std::max(0.0, std::abs(p.z()) - 1));
       },
       cylinder_stack(1.5, 2, error)},
      {"sphere", [](const Vec3& p) { return std::max(0.0, p.norm() - 1.5); },
       ellipsoid_stack(Vec3::Constant(1.5), error)},
      {"capsule",
       [](const Vec3& p) {
         return std::max(0.0, (p - Vec3(0, 0, std::clamp(p.z(), -1.0, 1.0))).norm() - 0.75);
       },
       capsule_stack(0.75, 2, error)},
      {"cone",
       [=](const Vec3& p) {  // radius 1 at -1, a point at 1: from its section, a triangle
         const Eigen::Vector2d q(along(p), p.z());
         const auto to = [&](Eigen::Vector2d a, Eigen::Vector2d b) {
           const double t = std::clamp((q - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
           return (q - a - t * (b - a)).norm();
         };
         const bool inside = q.y() >= -1 && q.x() <= 0.5 * (1 - q.y());
         return inside ? 0 : std::min(to({1, -1}, {0, 1}), to({0, -1}, {1, -1}));
       },
       cone_stack(1, 2, error)},
  };
}

Eigen::Matrix3d some_turn(std::mt19937_64& random, int kind) {
  std::uniform_real_distribution<double> angle(-3, 3);
  if (kind == 0) return Eigen::Matrix3d::Identity();
  if (kind == 1) return Eigen::AngleAxisd(angle(random), Vec3::UnitZ()).toRotationMatrix();
  if (kind == 2) return Eigen::AngleAxisd(angle(random), Vec3::UnitX()).toRotationMatrix();
  return (Eigen::AngleAxisd(angle(random), Vec3::UnitX()) *
          Eigen::AngleAxisd(angle(random), Vec3::UnitY()))
      .toRotationMatrix();
}

TEST(RingStack, HoldsItsBodyWithinTheError) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> place(-2.5, 2.5);
  for (const Body& body : bodies(0.01)) {
    for (const Vec3& c : body.stack.corners) EXPECT_LE(body.distance(c), 0.0100001) << body.name;
    const auto boxes = cover(body.stack, 0.05);
    for (int k = 0; k < 2000; ++k) {
      const Vec3 p(place(random), place(random), place(random));
      if (body.distance(p) > 0) continue;
      EXPECT_TRUE(
          std::any_of(boxes.begin(), boxes.end(), [&](const Aabb& b) { return contains(b, p); }))
          << body.name << ' ' << p.transpose();
    }
  }
}

// Points of the body, and of boxes beyond it, are found by walking from one to the other.
TEST(RingStack, IsCoveredWithinTheSlack) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> place(-3, 3);
  for (const double slack : {0.3, 0.15}) {
    for (const Body& body : bodies(0.2 * slack)) {
      for (int kind = 0; kind < 4; ++kind) {
        const Eigen::Matrix3d turn = some_turn(random, kind);
        RingStack turned = body.stack;
        for (Vec3& c : turned.corners) c = turn * c;
        const auto boxes = cover(turned, 0.8 * slack);
        const auto far = [&](const Vec3& p) { return body.distance(turn.transpose() * p); };
        const auto covered = [&](const Vec3& p) {
          return std::any_of(boxes.begin(), boxes.end(),
                             [&](const Aabb& b) { return contains(b, p); });
        };
        for (const Aabb& b : boxes) {  // distance to a convex body is largest at a corner
          for (int i = 0; i < 8; ++i) {
            const Vec3 corner(i & 1 ? b.max.x() : b.min.x(), i & 2 ? b.max.y() : b.min.y(),
                              i & 4 ? b.max.z() : b.min.z());
            ASSERT_LE(far(corner), slack) << body.name << ' ' << kind << ' ' << slack;
          }
        }
        for (int k = 0; k < 100; ++k) {
          Vec3 p(place(random), place(random), place(random));
          Vec3 inside = Vec3::Zero();
          for (int i = 0; i < 60; ++i) {  // the body is convex and holds 0: to its surface
            const Vec3 middle = 0.5 * (inside + p);
            (far(middle) > 0 ? p : inside) = middle;
          }
          ASSERT_TRUE(covered(inside)) << body.name << ' ' << kind << ' ' << inside.transpose();
        }
      }
    }
  }
}

TEST(RingStack, IsOneBoxWhereThatWillDo) {
  EXPECT_EQ(cover(box_stack({4, 2, 1}), 0.1).size(), 1u);
  RingStack hardly = box_stack({4, 2, 1});
  for (Vec3& c : hardly.corners) c = Eigen::AngleAxisd(1e-6, Vec3(1, 1, 1).normalized()) * c;
  EXPECT_EQ(cover(hardly, 0.1).size(), 1u);
}

TEST(RingStack, RefusesWhatTakesTooMuch) {
  EXPECT_THROW(cylinder_stack(1e8, 1, 1e-3), InputError);
  EXPECT_THROW(cover(box_stack({4, 2, 1}), 1e-6), InputError);
  EXPECT_THROW(cover(box_stack({4, 2, 1}), std::nan("")), InputError);
  EXPECT_THROW(ellipsoid_stack(Vec3::Constant(1000), 0.05), InputError);
  EXPECT_THROW(capsule_stack(1000, 1, 0.05), InputError);
}

}  // namespace
}  // namespace geom
