#include "collision/box_walk.h"

#include <gtest/gtest.h>

#include <optional>

#include "collision/split_tree.h"
#include "support/cases.h"
#include "support/random_city.h"

// What meets, or is near, must be among the candidates, of each kind of lanes that this processor
// has.

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
  out.built = split_tree(out.boxes);
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

// Calls f(lanes) of each kind.
template <class F>
void each_kind(const F& f) {
#if defined(__x86_64__)
  if (lanes::Avx512::usable()) lanes::on_avx512(f);
  if (lanes::Avx2::usable()) lanes::on_avx2(f);
#endif
  f(lanes::Plain{});
}

// Which boxes a walk asks about, none of them twice.
class Asked {
 public:
  explicit Asked(const World& w) : world_(w), asked_(w.boxes.size()) {}

  void add(std::size_t k) {
    const std::size_t box = world_.built.order[k];
    EXPECT_FALSE(asked_[box]);
    asked_[box] = true;
  }
  bool operator[](std::size_t box) const { return asked_[box]; }

 private:
  const World& world_;
  std::vector<bool> asked_;
};

void expect_all_on(const World& w, const Vec3& a, const Vec3& b) {
  const SegmentInTree s(w.built.tree.frame, a, b);
  each_kind([&](auto lanes) SKYWAY_ANY_LANES {
    Asked asked(w);
    const auto add = [&](std::size_t k) {
      asked.add(k);
      return false;
    };
    EXPECT_FALSE(any_meeting<decltype(lanes)>(w.built.tree.nodes.data(), s, add));
    for (std::size_t i = 0; i < w.boxes.size(); ++i) {
      EXPECT_TRUE(asked[i] || !segment_hits(a, b, w.boxes[i]));
    }
  });
}

// A search that a box may end of which roundings leave no doubt.
void expect_hit_as_exactly(const World& w, const Vec3& a, const Vec3& b) {
  const auto hits = [&](std::size_t k) { return segment_hits(a, b, w.boxes[w.built.order[k]]); };
  bool expected = false;
  for (std::size_t k = 0; k < w.boxes.size(); ++k) expected = expected || hits(k);
  const auto sure = [&](std::size_t k) { EXPECT_TRUE(hits(k)); };
  const BoxNode* const nodes = w.built.tree.nodes.data();
  const SegmentInTree s(w.built.tree.frame, a, b);
  const RegionInTree r(w.built.tree.frame, {a, a});
  each_kind([&](auto lanes) SKYWAY_ANY_LANES {
    EXPECT_EQ(any_meeting<decltype(lanes)>(nodes, s, hits, sure), expected);
    if (a == b) {
      EXPECT_EQ(any_meeting<decltype(lanes)>(nodes, r, hits, sure), expected);
    }
  });
}

void expect_all_in(const World& w, const Aabb& region) {
  const BoxNode* const nodes = w.built.tree.nodes.data();
  const RegionInTree r(w.built.tree.frame, region);
  each_kind([&](auto lanes) SKYWAY_ANY_LANES {
    Asked one_by_one(w);
    const auto add = [&](std::size_t k) {
      one_by_one.add(k);
      return false;
    };
    EXPECT_FALSE(any_meeting<decltype(lanes)>(nodes, r, add));
    Asked in_batches(w);
    const auto add_some = [&](std::span<const std::uint32_t> boxes) {
      for (const std::uint32_t box : boxes) in_batches.add(box & ~BoxNode::kBox);
      return false;
    };
    EXPECT_FALSE(each_in_region<decltype(lanes)>(nodes, r, add_some));
    for (std::size_t i = 0; i < w.boxes.size(); ++i) {
      EXPECT_TRUE(one_by_one[i] || !overlap(region, w.boxes[i]));
      EXPECT_EQ(in_batches[i], one_by_one[i]);
    }
  });
}

void expect_all_near(const World& w, const Vec3& p, double radius) {
  const PointInTree at(w.built.tree.frame, p);
  each_kind([&](auto lanes) SKYWAY_ANY_LANES {
    Asked asked(w);
    const auto add = [&](std::size_t k) {
      asked.add(k);
      return radius;
    };
    each_near<decltype(lanes)>(w.built.tree.nodes.data(), at, radius, add);
    for (std::size_t i = 0; i < w.boxes.size(); ++i) {
      EXPECT_TRUE(asked[i] || distance(p, w.boxes[i]) > radius);
    }
  });
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
      expect_hit_as_exactly(w, a, b);
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
  const World w = world(1, 1000, 300, Vec3::Zero());
  const BoxNode* const nodes = w.built.tree.nodes.data();
  const RegionInTree r(w.built.tree.frame, {Vec3::Constant(-1e3), Vec3::Constant(1e3)});
  each_kind([&](auto lanes) SKYWAY_ANY_LANES {
    int asked = 0;
    const auto third = [&](std::size_t) { return ++asked == 3; };
    EXPECT_TRUE(any_meeting<decltype(lanes)>(nodes, r, third));
    EXPECT_EQ(asked, 3);
    int batches = 0;
    const auto second = [&](std::span<const std::uint32_t>) { return ++batches == 2; };
    EXPECT_TRUE(each_in_region<decltype(lanes)>(nodes, r, second));
    EXPECT_EQ(batches, 2);
  });
}

// A radius that shrinks to the nearest found leaves most boxes unasked.
TEST(BoxWalk, LooksAtLittleOnceSomethingNearWasFound) {
  const World w = world(1, 5000, 3000, Vec3::Zero());
  each_kind([&](auto lanes) SKYWAY_ANY_LANES {
    support::Random random(9);
    std::size_t asked = 0;
    for (int i = 0; i < 100; ++i) {
      const Vec3 p(random.uniform(-3000, 3000), random.uniform(-3000, 3000),
                   random.uniform(-3000, 3000));
      double best = kInfinity;
      const auto ask = [&](std::size_t k) {
        ++asked;
        return best = std::min(best, distance(p, w.boxes[w.built.order[k]]));
      };
      each_near<decltype(lanes)>(w.built.tree.nodes.data(), PointInTree(w.built.tree.frame, p),
                                 best, ask);
      double nearest = kInfinity;
      for (const Aabb& box : w.boxes) nearest = std::min(nearest, distance(p, box));
      EXPECT_EQ(best, nearest);
    }
    EXPECT_LT(asked, 3000u);
  });
}

// In a city mostly no more than a few times as far as the nearest.
TEST(BoxWalk, FirstAsksForABoxNearby) {
  const World w = world(1, 5000, 3000, Vec3::Zero());
  each_kind([&](auto lanes) SKYWAY_ANY_LANES {
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
      each_near<decltype(lanes)>(w.built.tree.nodes.data(), PointInTree(w.built.tree.frame, p),
                                 kInfinity, ask);
      if (!first || *first >= w.boxes.size()) {
        ADD_FAILURE() << "no box";
        return;
      }
      likely += distance(p, w.boxes[w.built.order[*first]]);
      double least = kInfinity;
      for (const Aabb& box : w.boxes) least = std::min(least, distance(p, box));
      nearest += least;
    }
    EXPECT_LT(likely, 3 * nearest);
  });
}

}  // namespace
}  // namespace geom
