#include "shape/slack_gauge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/cover_oracle.h"
#include "support/random_city.h"

namespace geom {
namespace {

// The edges of a polygon, and what the gauge says of a slab's rectangle.
class Gauged {
 public:
  Gauged(Polygon polygon, double slack)
      : polygon_(std::move(polygon)), gauge_(slack, polygon_.holes.size() + 1) {
    add_edges(polygon_.outer, 0, edges_);
    for (std::size_t i = 0; i < polygon_.holes.size(); ++i) {
      add_edges(polygon_.holes[i], static_cast<int>(i) + 1, edges_);
    }
    std::sort(edges_.begin(), edges_.end(),
              [](const CoverEdge& a, const CoverEdge& b) { return a.low.y() < b.low.y(); });
  }

  std::optional<bool> clear_case(double y0, double y1) {
    std::vector<const CoverEdge*> begun;
    for (const CoverEdge& edge : edges_) {
      if (edge.low.y() <= y0) begun.push_back(&edge);
    }
    gauge_.begin(y0, begun);
    for (std::size_t i = begun.size(); i < edges_.size(); ++i) gauge_.add(edges_[i]);
    gauge_.reach_to(y1);
    return gauge_.clear_case();
  }

  bool allows(const Rectangle& r) { return gauge_.allows(r); }
  // Of the slab that was looked at last, up to y1: once by the corner that is followed from `least`
  // on, and once by all edges.
  std::pair<bool, bool> corner_refuses(double least, double y1) {
    gauge_.follow_corner(least);
    const bool followed = gauge_.corner_refuses(y1);
    gauge_.reach_to(y1);
    return {followed, gauge_.refuses_again()};
  }
  bool refuses_further(double rise) { return gauge_.refuses_further(rise); }

  double furthest(const Rectangle& r) const { return oracle::furthest_outside(polygon_, r, 1e-4); }

 private:
  Polygon polygon_;
  std::vector<CoverEdge> edges_;
  SlackGauge gauge_;
};

const Polygon kTriangle{{{0, 0}, {10, 0}, {0, 10}}, {}};

TEST(SlackGauge, TellsClearCasesOfASlab) {
  Gauged gauged(kTriangle, 1);
  EXPECT_EQ(gauged.clear_case(2, 3), true);   // the corner is 0.71 m from the slope
  EXPECT_EQ(gauged.clear_case(2, 4), false);  // 1.41 m
  EXPECT_EQ(gauged.clear_case(2, 4), false);  // by the corner that refused before
}

TEST(SlackGauge, TellsCloseCasesByTheCorner) {
  Gauged gauged(kTriangle, 1);
  for (const double share : {0.98, 0.999, 0.99997, 0.99999, 1.0, 1.00001}) {
    EXPECT_EQ(gauged.clear_case(2, 2 + share * std::sqrt(2.0)), share < 0.99998) << share;
  }
}

TEST(SlackGauge, HalvesWhatLiesBesideManyEdges) {
  Polygon comb{{{0, 0}, {10, 0}, {0, 10}}, {}};
  for (int i = 0; i < 70; ++i) comb.holes.push_back({{0.1, 4 + 1e-3 * i}, {0.2, 4 + 1e-3 * i}});
  Gauged gauged(comb, 1);
  for (const double share : {0.9, 1.1}) {
    const double high = 2 + share * std::sqrt(2.0);
    ASSERT_EQ(gauged.clear_case(2, high), std::nullopt) << share;
    EXPECT_EQ(gauged.allows({{0, 2}, {8, high}}), share < 1) << share;
    EXPECT_TRUE(gauged.allows({{0, 2}, {7, high}}));  // away from the slab's corner
  }
}

TEST(SlackGauge, RefusesWhatFillsAHole) {
  const Polygon ring{{{0, 0}, {20, 0}, {20, 20}, {0, 20}}, {{{5, 5}, {15, 5}, {15, 15}, {5, 15}}}};
  Gauged gauged(ring, 1);
  EXPECT_EQ(gauged.clear_case(6, 8), true);
  EXPECT_EQ(gauged.clear_case(2, 8), false);  // what the hole's lower side bounds
}

TEST(SlackGauge, AllowsNoRectangleThatReachesFurtherThanTheSlack) {
  support::Random random(2);
  int cleared = 0;
  int allowed = 0;
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    Polygon star;
    const int corners = 3 + random.below(i % 20 == 0 ? 120 : 9);  // more than 64: halving alone
    for (int k = 0; k < corners; ++k) {
      const double angle = 2 * M_PI * k / corners;
      star.outer.push_back(random.uniform(2, 9) * Vec2(std::cos(angle), std::sin(angle)));
    }
    Gauged gauged(star, 0.5);
    const Vec2& a = star.outer[0];
    const Vec2& b = star.outer[1];
    const CoverEdge edge{a.y() <= b.y() ? a : b, a.y() <= b.y() ? b : a, 0, 1};
    // A slab whose rectangle around an edge has a corner about the slack away from it.
    const double y0 = edge.low.y() + random.uniform(0, 0.2);
    const double y1 = y0 + random.uniform(0.48, 0.51) * edge.step.norm() / std::abs(edge.step.x());
    const auto clear = gauged.clear_case(y0, y1);
    if (edge.low.y() >= y1 || edge.high.y() <= y0) continue;
    const Interval x = edge.range(y0, y1);
    const Rectangle r{{x.low, y0}, {x.high, y1}};
    const double furthest = gauged.furthest(r);
    if (clear.value_or(false)) {
      ASSERT_LE(furthest, 0.5) << i;
      ++cleared;
      continue;
    }
    if (clear) continue;  // another edge's may reach further
    const bool allows = gauged.allows(r);
    if (allows) {
      ASSERT_LE(furthest, 0.5 * (1 + 2e-4)) << i;
      ++allowed;
    } else {
      ASSERT_GT(furthest, 0.5 * 0.9) << i;
      ++refused;
    }
  }
  EXPECT_GT(cleared, 100);
  EXPECT_GT(allowed, 5);
  EXPECT_GT(refused, 5);
}

TEST(SlackGauge, RefusesFurtherWhatItRefusesAtEachHeight) {
  support::Random random(8);
  std::size_t further = 0;
  for (int k = 0; k < 2000; ++k) {
    Polygon polygon;
    for (int i = 0; i < 3 + k % 4; ++i) {
      polygon.outer.push_back({random.uniform(0, 20), random.uniform(0, 20)});
    }
    Gauged gauged(polygon, 1);
    const double y0 = random.uniform(0, 18);
    const double y1 = y0 + random.uniform(0.5, 3);
    const double rise = random.uniform(0, 5);
    if (gauged.clear_case(y0, y1) != false || !gauged.refuses_further(rise)) continue;
    ++further;
    for (int i = 0; i <= 10; ++i) {
      EXPECT_EQ(gauged.clear_case(y0 + 0.1 * i * rise, y1 + 0.1 * i * rise), false)
          << "case " << k << ", moved up by " << 0.1 * i * rise;
    }
  }
  EXPECT_GT(further, 100u);
}

TEST(SlackGauge, TheCornerThatIsFollowedSaysWhatAllEdgesSay) {
  support::Random random(9);
  int refused = 0;
  int allowed = 0;
  for (int k = 0; k < 4000; ++k) {
    const double away = k % 2 == 0 ? 0 : 9e7;
    Polygon polygon;
    for (int i = 0; i < 3 + k % 6; ++i) {
      polygon.outer.push_back({away + random.uniform(0, 20), away + random.uniform(0, 20)});
    }
    Gauged gauged(polygon, 1);
    const double y0 = away + random.uniform(0, 18);
    const double y1 = y0 + random.uniform(0.5, 5);
    if (gauged.clear_case(y0, y1) != false) continue;
    const auto [followed, all] = gauged.corner_refuses(y0 + 1e-3, random.uniform(y0 + 1e-3, y1));
    ASSERT_EQ(followed, all) << k;
    ++(all ? refused : allowed);
  }
  EXPECT_GT(refused, 100);
  EXPECT_GT(allowed, 100);
}

}  // namespace
}  // namespace geom
