#include "collision/box_walk.h"

#include <gtest/gtest.h>

#include <optional>

#include "collision/embree_tree.h"
#include "support/cases.h"
#include "support/random_city.h"

// What meets, or is near, must be among the candidates: of the walk of this processor, and of the
// plain one.

namespace geom {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct World {
  std::vector<Aabb> boxes;
  BuiltTree built;
  Vec3 centre;
  double size;
};

World world(std::uint64_t seed, int count, double size, const Vec3& centre) {
  support::Random random(seed);
  World out{{}, {}, centre, size};
  for (int i = 0; i < count; ++i) {
    Vec3 low;
    Vec3 length;
    for (int k = 0; k < 3; ++k) {
      low[k] = centre[k] + random.stepped(-size, size, size / 64);
      length[k] = random.below(3) ? random.stepped(0, size / 8, size / 64) : 0;
    }
    out.boxes.push_back({low, low + length});
  }
  out.built = embree_tree(out.boxes);
  return out;
}

// In the world or up to a million times further out; often on the planes of boxes.
Vec3 point(support::Random& random, const World& w) {
  Vec3 p;
  const double reach = random.below(4) ? 1.2 : std::pow(10.0, random.uniform(0, 6));
  for (int k = 0; k < 3; ++k) {
    p[k] = w.centre[k] + (random.below(2) ? random.stepped(-w.size, w.size, w.size / 64)
                                          : random.uniform(-w.size, w.size)) *
                             reach;
  }
  return p;
}

std::vector<bool> all_false(const World& w) { return std::vector<bool>(w.boxes.size()); }

void expect_all_on(const World& w, const Vec3& a, const Vec3& b) {
  std::vector<bool> asked = all_false(w);
  std::vector<bool> asked_plainly = all_false(w);
  any_on_segment(w.built.tree, a, b, [&](std::size_t i) {
    asked[w.built.order[i]] = true;
    return false;
  });
  const SegmentInTree s(w.built.tree.frame, a, b);
  if (!s.outside) {
    walk::any<lanes::Plain>(w.built.tree.nodes.data(), lanes::Plain::on, s, [&](std::size_t i) {
      asked_plainly[w.built.order[i]] = true;
      return false;
    });
  }
  for (std::size_t i = 0; i < w.boxes.size(); ++i) {
    if (!segment_hits(a, b, w.boxes[i])) continue;
    EXPECT_TRUE(asked[i]);
    EXPECT_TRUE(asked_plainly[i]);
  }
}

void expect_all_in(const World& w, const Aabb& region) {
  std::vector<bool> asked = all_false(w);
  any_in_region(w.built.tree, region, [&](std::size_t k) {
    const std::size_t i = w.built.order[k];
    EXPECT_FALSE(asked[i]);
    asked[i] = true;
    return false;
  });
  for (std::size_t i = 0; i < w.boxes.size(); ++i) {
    EXPECT_TRUE(asked[i] || !overlap(region, w.boxes[i]));
  }
}

void expect_all_near(const World& w, const Vec3& p, double radius) {
  std::vector<bool> asked = all_false(w);
  std::vector<bool> asked_plainly = all_false(w);
  each_near(w.built.tree, p, radius, [&](std::size_t i) {
    asked[w.built.order[i]] = true;
    return radius;
  });
  const PointInTree at(w.built.tree.frame, p);
  walk::nearest<lanes::Plain>(w.built.tree.nodes.data(), at, radius, [&](std::size_t i) {
    asked_plainly[w.built.order[i]] = true;
    return radius;
  });
  for (std::size_t i = 0; i < w.boxes.size(); ++i) {
    if (distance(p, w.boxes[i]) > radius) continue;
    EXPECT_TRUE(asked[i]);
    EXPECT_TRUE(asked_plainly[i]);
  }
}

struct Scale {
  double size;
  Vec3 centre;
};

class BoxWalk : public testing::TestWithParam<Scale> {};

TEST_P(BoxWalk, FindsAllThatIsMetAndAllThatIsNear) {
  for (int seed = 0; seed < 4; ++seed) {
    const World w = world(static_cast<std::uint64_t>(seed), seed == 0 ? 1 : 400, GetParam().size,
                          GetParam().centre);
    support::Random random(100 + static_cast<std::uint64_t>(seed));
    for (int i = 0; i < support::cases(500); ++i) {
      const Vec3 a = point(random, w);
      Vec3 b = random.below(4) ? point(random, w) : a;
      if (random.below(3) == 0) b[random.below(3)] = a[random.below(3)];
      expect_all_on(w, a, b);
      expect_all_in(w, {a.cwiseMin(b), a.cwiseMax(b)});
      // As far as a box, to the last digit.
      const auto box = static_cast<std::size_t>(random.below(static_cast<int>(w.boxes.size())));
      expect_all_near(w, a, random.below(8) ? distance(a, w.boxes[box]) : kInfinity);
      if (HasFailure()) {
        FAIL() << "seed " << seed << ", case " << i << ": " << a.transpose() << " to "
               << b.transpose();
      }
    }
    expect_all_in(w, {Vec3::Constant(-kInfinity), Vec3::Constant(kInfinity)});
  }
}

INSTANTIATE_TEST_SUITE_P(Scales, BoxWalk,
                         testing::Values(Scale{300, {0, 0, 0}}, Scale{300, {4e6, 5e5, 100}},
                                         Scale{40000, {1e5, -1e5, 0}}, Scale{1e-4, {7, 8, 9}},
                                         Scale{0.5, {1e8, -1e8, 1e8}}, Scale{1e8, {0, 0, 0}}));

TEST(BoxWalk, EndsWhereItIsToldTo) {
  const World w = world(1, 100, 300, Vec3::Zero());
  int asked = 0;
  EXPECT_TRUE(any_in_region(w.built.tree, {Vec3::Constant(-1e3), Vec3::Constant(1e3)},
                            [&](std::size_t) { return ++asked == 3; }));
  EXPECT_EQ(asked, 3);
}

// A radius that shrinks to the nearest found leaves most boxes unasked.
TEST(BoxWalk, LooksAtLittleOnceSomethingNearWasFound) {
  const World w = world(1, 5000, 3000, Vec3::Zero());
  support::Random random(9);
  std::size_t asked = 0;
  for (int i = 0; i < 100; ++i) {
    const Vec3 p(random.uniform(-3000, 3000), random.uniform(-3000, 3000),
                 random.uniform(-3000, 3000));
    double best = kInfinity;
    each_near(w.built.tree, p, best, [&](std::size_t k) {
      ++asked;
      return best = std::min(best, distance(p, w.boxes[w.built.order[k]]));
    });
    double nearest = kInfinity;
    for (const Aabb& box : w.boxes) nearest = std::min(nearest, distance(p, box));
    EXPECT_EQ(best, nearest);
  }
  EXPECT_LT(asked, 3000u);
}

// In a city mostly no more than a few times as far as the nearest.
TEST(BoxWalk, FirstAsksForABoxNearby) {
  const World w = world(1, 5000, 3000, Vec3::Zero());
  support::Random random(10);
  double likely = 0;
  double nearest = 0;
  for (int i = 0; i < 100; ++i) {
    const Vec3 p = point(random, w);
    std::optional<std::size_t> first;
    const auto ask = [&](std::size_t k) {
      if (!first) first = k;
      return 0.0;
    };
    walk::nearest<lanes::Plain>(w.built.tree.nodes.data(), PointInTree(w.built.tree.frame, p),
                                kInfinity, ask);
    ASSERT_TRUE(first);
    ASSERT_LT(*first, w.boxes.size());
    first = std::nullopt;
    each_near(w.built.tree, p, kInfinity, ask);
    ASSERT_TRUE(first);
    ASSERT_LT(*first, w.boxes.size());
    likely += distance(p, w.boxes[w.built.order[*first]]);
    double least = kInfinity;
    for (const Aabb& box : w.boxes) least = std::min(least, distance(p, box));
    nearest += least;
  }
  EXPECT_LT(likely, 3 * nearest);
}

}  // namespace
}  // namespace geom
