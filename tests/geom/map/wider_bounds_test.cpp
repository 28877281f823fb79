#include "geom/map/wider_bounds.h"

#include <gtest/gtest.h>

#include <string>

#include "support/random_city.h"

namespace geom {
namespace {

const Aabb kBounds{{0, 0, 0}, {80.5, 60, 60}};

TEST(WiderBounds, SaysNothingOfWhatIsInside) {
  WiderBounds wider(kBounds);
  wider.add({{0, 0, 0}, {80.5, 60, 60}});
  EXPECT_FALSE(wider.any());
  EXPECT_EQ(wider.in_words(), "");
  EXPECT_EQ(wider.option(), "");
  EXPECT_EQ(wider.advice(), "");
}

TEST(WiderBounds, NamesTheFaceAndTheOptionOfEachDirection) {
  WiderBounds above(kBounds);
  above.add({{1, 1, 1}, {2, 2, 60.4}});
  EXPECT_EQ(above.in_words(), "0.4 m above the ceiling, z = 60");
  EXPECT_EQ(above.option(), "--ceiling 61");

  WiderBounds below(kBounds);
  below.add({{1, 1, -2}, {2, 2, 3}});
  EXPECT_EQ(below.in_words(), "2 m below the floor, z = 0");
  EXPECT_EQ(below.option(), "--floor -2");

  WiderBounds aside(kBounds);
  aside.add({{-3.25, 1, 1}, {2, 61, 3}});
  EXPECT_EQ(aside.in_words(), "3.25 m beyond x = 0 and 1 m beyond y = 60");
  EXPECT_EQ(aside.option(), "--bounds=-4,0,0,80.5,61,60");
  EXPECT_NE(aside.advice().find("skyway-map bounds MAP --bounds=-4,0,0,80.5,61,60"),
            std::string::npos);
}

TEST(WiderBounds, HoldsAllThatWasAdded) {
  WiderBounds wider(kBounds);
  wider.add({{1, 1, -0.5}, {2, 2, 3}});
  wider.add({{1, 1, 1}, {2, 2, 70}});
  EXPECT_EQ(wider.in_words(), "0.5 m below the floor, z = 0 and 10 m above the ceiling, z = 60");
  EXPECT_EQ(wider.option(), "--floor -1 --ceiling 70");
}

TEST(WiderBounds, TakesARoundingForAWholeMetre) {
  WiderBounds wider(kBounds);
  wider.add({{1, 1, 1}, {2, 2, 70 + 1e-9}});
  EXPECT_EQ(wider.option(), "--ceiling 70");
  WiderBounds hair(kBounds);
  hair.add({{1, 1, 1}, {2, 2, 60 + 1e-5}});
  EXPECT_EQ(hair.in_words(), "less than 1 mm above the ceiling, z = 60");
}

bool within(const Aabb& inner, const Aabb& outer) {
  return contains(outer, inner.min) && contains(outer, inner.max);
}

// The bounds that the option of skyway-map bounds gives.
Aabb widened(const Aabb& bounds, const std::string& option) {
  Aabb out = bounds;
  const auto number_behind = [&](const std::string& word, double& value) {
    const std::size_t at = option.find(word);
    if (at != std::string::npos) value = std::stod(option.substr(at + word.size()));
  };
  number_behind("--floor ", out.min.z());
  number_behind("--ceiling ", out.max.z());
  std::size_t at = option.find('=');
  for (int i = 0; i < 6 && at != std::string::npos; ++i) {
    (i < 3 ? out.min : out.max)[i % 3] = std::stod(option.substr(at + 1));
    at = option.find(',', at + 1);
  }
  return out;
}

TEST(WiderBounds, GivesAnOptionThatHoldsAllAndLittleMore) {
  support::Random random(3);
  for (int i = 0; i < 2000; ++i) {
    WiderBounds wider(kBounds);
    Aabb all = kBounds;
    for (int n = 0; n < 1 + i % 3; ++n) {
      const Vec3 low(random.uniform(-20, 90), random.uniform(-20, 90), random.uniform(-9, 90));
      const Aabb room{low, low + Vec3::Constant(random.uniform(0, 9))};
      wider.add(room);
      all = merged(all, room);
    }
    const Aabb made = widened(kBounds, wider.option());
    EXPECT_TRUE(within(all, grow(made, Vec3::Constant(1e-6)))) << "seed 3, case " << i;
    EXPECT_TRUE(within(made, grow(all, Vec3::Constant(1)))) << "seed 3, case " << i;
    EXPECT_EQ(wider.any(), !(all == kBounds)) << "seed 3, case " << i;
  }
}

TEST(WiderBounds, GoesAsFarOutAsIsSaidBesideTheFurthestFace) {
  WiderBounds wider(kBounds);
  wider.add({10, 10, 59.5}, {1, 1, 1}, 2.5);
  EXPECT_EQ(wider.in_words(), "2.5 m above the ceiling, z = 60");
  WiderBounds nearer(kBounds);
  nearer.add({0.5, 10, 30}, {1, 1, 1}, 0);
  EXPECT_EQ(nearer.in_words(), "0.5 m beyond x = 0");
}

}  // namespace
}  // namespace geom
