#include "map/held_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "map/held_within.h"
#include "support/random_city.h"

namespace geom {
namespace {

using support::Random;

constexpr double kRise = 1e-9;

WallStretch random_stretch(Random& random, int k) {
  const double turn = k % 3 == 0 ? 0 : random.uniform(0, 7);
  const double thickness = k % 2 ? random.uniform(0, 0.1) : 0;
  const Vec2 along(std::cos(turn), std::sin(turn));
  const Vec2 across(-along.y(), along.x());
  const Vec2 start(random.uniform(-2, 2) + (k % 5 ? 0 : 3e4), random.uniform(-2, 2));
  const Vec2 end = start + along * random.uniform(0, 8);
  return {{start, start + across * thickness, random.uniform(3, 6)},
          {end, end + across * thickness, k % 4 ? random.uniform(3, 6) : 4},
          0};
}

// Their sides at places of the stretch, or anywhere.
std::vector<Aabb> random_boxes(Random& random, const WallStretch& s) {
  std::vector<Aabb> out;
  for (int i = 0; i < 6; ++i) {
    const auto place = [&] {
      const double t = std::round(random.uniform(0, 4)) / 4;
      return Vec2(s.from.near + t * (s.to.near - s.from.near) +
                  Vec2(random.uniform(-1, 1), random.uniform(-1, 1)) * (i % 3));
    };
    const Vec2 a = place();
    const Vec2 b = place() + Vec2(1e-9, i % 2 ? 0.1 : 0);
    const Vec2 low = a.cwiseMin(b);
    const Vec2 high = a.cwiseMax(b);
    out.push_back({{low.x(), low.y(), i % 5 ? -1.0 : 0.5},
                   {high.x(), high.y(), i % 2 ? s.to.top : random.uniform(3, 7)}});
  }
  return out;
}

Footprint part_of(const WallStretch& s, double from, double to) {
  const auto at = [](const Vec2& a, const Vec2& b, double t) { return Vec2(a + t * (b - a)); };
  const auto top = [&](double t) { return s.from.top + t * (s.to.top - s.from.top); };
  Footprint out;
  out.polygon.outer = {at(s.from.near, s.to.near, from), at(s.from.near, s.to.near, to),
                       at(s.from.far, s.to.far, to), at(s.from.far, s.to.far, from)};
  out.bottom = s.bottom;
  out.top = std::max(top(from), top(to)) + kRise;
  return out;
}

TEST(HeldParts, SaysOfEachPartWhatIsTrueOfIt) {
  Random random(5);
  HeldWithin is_held;
  std::size_t known[2] = {0, 0};
  std::size_t asked = 0;
  for (int k = 0; k < 3000; ++k) {
    const WallStretch stretch = random_stretch(random, k);
    const std::vector<Aabb> boxes = random_boxes(random, stretch);
    const std::size_t count = 1 + static_cast<std::size_t>(random.uniform(0, 30));
    const std::vector<Held> held = held_parts(stretch, count, kRise, boxes);
    ASSERT_EQ(held.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
      if (held[i] == Held::perhaps) {
        ++asked;
        continue;
      }
      const auto n = static_cast<double>(count);
      const auto first = static_cast<double>(i);
      const bool truth = is_held(part_of(stretch, first / n, (first + 1) / n), boxes);
      EXPECT_EQ(held[i] == Held::yes, truth) << "case " << k << ", part " << i << " of " << count;
      ++known[truth];
    }
  }
  EXPECT_GT(known[0], 10000u);
  EXPECT_GT(known[1], 1000u);
  EXPECT_LT(asked, known[0] + known[1]);
}

}  // namespace
}  // namespace geom
