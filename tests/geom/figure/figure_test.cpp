#include "geom/figure/figure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using geom::figure::Point;

TEST(Thinned, KeepsEndsAndExtremes) {
  std::vector<Point> points;
  for (int i = 0; i < 100000; ++i) points.push_back({i * 1e-3, std::sin(i * 1e-3)});
  points[34567].y = 9;
  points[76543].y = -9;
  const auto few = geom::figure::thinned(points, 500);
  EXPECT_LE(few.size(), 2000u);
  EXPECT_EQ(few.front().x, points.front().x);
  EXPECT_EQ(few.back().x, points.back().x);
  EXPECT_TRUE(std::is_sorted(few.begin(), few.end(),
                             [](const Point& a, const Point& b) { return a.x < b.x; }));
  const auto has = [&](double y) {
    return std::any_of(few.begin(), few.end(), [&](const Point& p) { return p.y == y; });
  };
  EXPECT_TRUE(has(9));
  EXPECT_TRUE(has(-9));
  EXPECT_EQ(geom::figure::thinned({{0, 1}, {1, 2}}, 500).size(), 2u);
}

}  // namespace
