#include "bound/convex_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "plan/scenes.h"

namespace plan {
namespace {

using geom::Aabb;

const Aabb kRoom{{0, 0, 0}, {20, 20, 20}};

double total(const std::vector<EdgePart>& edges) {
  double sum = 0;
  for (const EdgePart& edge : edges) sum += edge.length();
  return sum;
}

std::size_t corners(const std::vector<EdgePart>& edges) {
  return static_cast<std::size_t>(
      std::count_if(edges.begin(), edges.end(), [](const EdgePart& e) { return e.is_corner(); }));
}

TEST(ConvexEdges, OfABoxAreItsTwelve) {
  const auto edges = convex_edges(scene_of({{{5, 6, 7}, {8, 10, 12}}}, kRoom));
  EXPECT_EQ(edges.size(), 12u);
  EXPECT_EQ(corners(edges), 0u);
  EXPECT_NEAR(total(edges), 4 * (3 + 4 + 5), 1e-6);
}

TEST(ConvexEdges, AtTheBoundsThereAreNone) {
  const auto edges = convex_edges(scene_of({{{5, 6, 0}, {8, 10, 12}}}, kRoom));
  EXPECT_EQ(edges.size(), 8u);
  EXPECT_NEAR(total(edges), 2 * (3 + 4) + 4 * 12, 1e-6);
  EXPECT_TRUE(convex_edges(scene_of({kRoom}, kRoom)).empty());
}

TEST(ConvexEdges, CoveredStretchesAreLeftOut) {
  const Aabb tower{{5, 5, 0}, {10, 10, 15}};
  const Aabb house{{8, 6, 0}, {15, 9, 5}};
  const auto edges = convex_edges(scene_of({tower, house}, kRoom));
  EXPECT_EQ(corners(edges), 0u);
  // The tower keeps its edges, the house those of what sticks out.
  EXPECT_NEAR(total(edges), 4 * 5 + 4 * 15 + 2 * 5 + 3 + 2 * 5, 1e-6);
}

TEST(ConvexEdges, BoxesWithinOthersAndTwinsAddNothing) {
  const Aabb box{{5, 6, 7}, {8, 10, 12}};
  const Aabb inner{{5, 7, 8}, {8, 9, 12}};
  const auto one = convex_edges(scene_of({box}, kRoom));
  EXPECT_EQ(convex_edges(scene_of({box, box, inner}, kRoom)).size(), one.size());
}

TEST(ConvexEdges, FlushStepsHaveACorner) {
  const Aabb low{{5, 5, 0}, {8, 12, 5}};
  const Aabb high{{5, 8, 0}, {8, 12, 10}};  // flush on two sides
  EXPECT_EQ(corners(convex_edges(scene_of({low, high}, kRoom))), 2u);
}

TEST(ConvexEdges, CrossingEdgesHaveACorner) {
  const auto scene = scene_of({{{5, 9, 5}, {15, 11, 7}}, {{9, 5, 7}, {11, 15, 9}}}, kRoom);
  EXPECT_EQ(corners(convex_edges(scene)), 0u);  // grown, they cut into each other
}

TEST(ConvexEdges, PartsCoverTheirEdge) {
  const EdgePart edge{{1, 2, 3}, {1, 2, 28.3}, 2, {1, -1}};
  const auto parts = parts_of({edge, {{4, 4, 4}, {4, 4, 4}, kCorner, {}}}, 10);
  ASSERT_EQ(parts.size(), 4u);
  EXPECT_EQ(parts[0].low, edge.low);
  EXPECT_EQ(parts[0].high, parts[1].low);
  EXPECT_EQ(parts[1].high, parts[2].low);
  EXPECT_EQ(parts[2].high, edge.high);
  EXPECT_EQ(parts[2].outward, edge.outward);
  EXPECT_TRUE(parts[3].is_corner());
}

TEST(ConvexEdges, SidesAreClosedQuadrants) {
  const EdgePart edge{{5, 5, 0}, {5, 5, 9}, 2, {1, 1}};  // the box is below and left of it
  const auto of = [&](const Vec3& p) { return sides(edge, {p, p, kCorner, {}}); };
  EXPECT_EQ(of({7, 3, 4}), 1);
  EXPECT_EQ(of({3, 7, 4}), 2);
  EXPECT_EQ(of({7, 7, 4}), 0);
  EXPECT_EQ(of({3, 3, 4}), 0);
  EXPECT_EQ(of({7, 5, 4}), 1);
  EXPECT_EQ(of({5, 7, 4}), 2);
  EXPECT_EQ(of({5, 5, 12}), 0);  // on its own line
  EXPECT_EQ(sides(edge, {{3, 5, 20}, {7, 5, 20}, 0, {1, 1}}), 3);
  EXPECT_EQ(sides({{1, 1, 1}, {1, 1, 1}, kCorner, {}}, edge), 3);
}

// Eight octants, some blocked, and two directions from their centre.
class Cone {
 public:
  explicit Cone(unsigned blocked) : blocked_(blocked) {}

  // Whether every octant that the segment runs through, or along, leaves it free: cut where it
  // crosses a plane, each piece in the middle must be in some free octant, closed.
  bool free(const Vec3& a, const Vec3& b) const {
    std::vector<double> cuts{0, 1};
    for (int k = 0; k < 3; ++k) {
      const double t = a[k] / (a[k] - b[k]);
      if (t > 0 && t < 1) cuts.push_back(t);
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t i = 1; i < cuts.size(); ++i) {
      const double middle = 0.5 * (cuts[i - 1] + cuts[i]);
      if (!free(Vec3(a + middle * (b - a)))) return false;
    }
    return true;
  }
  bool free(const Vec3& p) const {
    for (unsigned octant = 0; octant < 8; ++octant) {
      if ((blocked_ >> octant & 1) || !in(octant, p)) continue;
      return true;
    }
    return false;
  }

  // Whether the path u, centre, v goes round an edge as docs/bound.md says.
  bool goes_round(const Vec3& u, const Vec3& v) const {
    for (int k = 0; k < 3; ++k) {
      for (const double end : {-1.0, 1.0}) {
        for (unsigned corner = 0; corner < 4; ++corner) {
          if (goes_round(k, end, corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, u, v)) return true;
        }
      }
    }
    return false;
  }

 private:
  static bool in(unsigned octant, const Vec3& p) {
    const unsigned larger[] = {octant & 4, octant & 2, octant & 1};
    for (int k = 0; k < 3; ++k) {
      if (std::abs(p[k]) > 1e-12 && (p[k] > 0) != (larger[k] != 0)) return false;
    }
    return true;
  }
  bool is_blocked(const Vec3& inner) const {
    const unsigned octant =
        (inner[0] > 0 ? 4u : 0) + (inner[1] > 0 ? 2u : 0) + (inner[2] > 0 ? 1u : 0);
    return blocked_ >> octant & 1;
  }
  bool goes_round(int k, double end, double out1, double out2, const Vec3& u, const Vec3& v) const {
    const int i1 = (k + 1) % 3;
    const int i2 = (k + 2) % 3;
    const auto octant = [&](double s1, double s2) {
      Vec3 p;
      p[k] = end;
      p[i1] = s1 * out1;
      p[i2] = s2 * out2;
      return is_blocked(p);
    };
    if (!octant(-1, -1) || octant(1, -1) || octant(-1, 1)) return false;
    const auto first = [&](const Vec3& p) { return p[i1] * out1 >= 0 && p[i2] * out2 <= 0; };
    const auto second = [&](const Vec3& p) { return p[i1] * out1 <= 0 && p[i2] * out2 >= 0; };
    return (first(u) && second(v)) || (second(u) && first(v));
  }

  unsigned blocked_;
};

// At a plain point a bend goes round an edge, or the path can be made shorter: by the straight
// line, or by moving the bend along an axis.
TEST(ConvexEdges, AtPlainPointsNoOtherPathBends) {
  support::Random random(7);
  int plain_ones = 0;
  for (unsigned blocked = 0; blocked < 255; ++blocked) {
    if (!plain(blocked)) continue;
    ++plain_ones;
    const Cone cone(blocked);
    for (int i = 0; i < 4000; ++i) {
      Vec3 ends[2];
      for (Vec3& p : ends) {
        do {
          for (int k = 0; k < 3; ++k) {
            p[k] = random.below(3) ? random.uniform(-1, 1) : random.below(3) - 1;
          }
        } while (p.norm() < 0.1 || !cone.free(p));
        p.normalize();
      }
      const auto& [u, v] = ends;
      if ((u + v).norm() < 0.05 || cone.goes_round(u, v) || cone.free(u, v)) continue;
      bool shorter = false;
      for (int k = 0; k < 3; ++k) {
        for (const double step : {-1e-4, 1e-4}) {
          const Vec3 bend = step * Vec3::Unit(k);
          shorter = shorter || ((u - bend).norm() + (v - bend).norm() < 2 && cone.free(u, bend) &&
                                cone.free(bend, v));
        }
      }
      ASSERT_TRUE(shorter) << blocked << ": " << u.transpose() << " and " << v.transpose();
    }
  }
  EXPECT_GT(plain_ones, 80);
}

}  // namespace
}  // namespace plan
