#include "roadmap/squares.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/random_city.h"

namespace plan {
namespace {

TEST(Squares, HaveACodeThatGivesThemBack) {
  constexpr std::int32_t kLeast = std::numeric_limits<std::int32_t>::min();
  constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();
  for (const std::int32_t column : {kLeast, -5, -1, 0, 1, 77, kMost}) {
    for (const std::int32_t row : {kLeast, -2, 0, 3, kMost}) {
      EXPECT_EQ(square_at(code_of({column, row})), (Square{column, row}));
    }
  }
  EXPECT_LT(code_of({-1, -1}), code_of({0, -1}));
  EXPECT_LT(code_of({0, -1}), code_of({-1, 0}));
  EXPECT_LT(code_of({-1, 0}), code_of({0, 0}));
}

// Whatever the reach: what is within it is in a square that an edge can name, and in its box.
TEST(Squares, AreWideEnoughForTheirReach) {
  support::Random random(1);
  for (const double reach : {1.0, 40.0, 99.9, 100.0, 500.0, 601.0, 7000.0, 1e5}) {
    const Squares squares(reach);
    ASSERT_LE(squares.slots(), 256u);
    for (int n = 0; n < 500; ++n) {
      const Vec3 p(random.uniform(-3e5, 3e5), random.uniform(-3e5, 3e5), 5);
      const Vec3 q = p + Vec3(random.uniform(-reach, reach), random.uniform(-reach, reach), 0);
      const Square from = squares.of(p);
      const Square to = squares.of(q);
      const std::uint32_t slot = squares.slot(from, to);
      ASSERT_LT(slot, squares.slots()) << reach;
      ASSERT_EQ(squares.beside(from, slot), to) << reach;
      const geom::Aabb box = squares.box(to, to, 1e-3);
      ASSERT_TRUE((box.min.array() <= q.array()).all() && (q.array() <= box.max.array()).all());
    }
  }
}

}  // namespace
}  // namespace plan
