#include "geom/base/usual_arithmetic.h"

#include <gtest/gtest.h>
#include <xmmintrin.h>

#include <limits>
#include <thread>

namespace geom {
namespace {

constexpr unsigned kDropsSmall = 0x8040;  // FTZ and DAZ

volatile double one = 1;
volatile double least = std::numeric_limits<double>::min();

bool is_usual() {
  const double third = one / 3;
  const double small = least / 2;
  return third == 0x1.5555555555555p-2 && -one / 3 == -third && small > 0;
}

TEST(UsualArithmetic, HoldsWhereTheProgramRoundsAnotherWay) {
  for (const int mode : {FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO}) {
    std::fesetround(mode);
    {
      const UsualArithmetic usual;
      EXPECT_TRUE(is_usual()) << mode;
    }
    EXPECT_EQ(std::fegetround(), mode);
    std::fesetround(FE_TONEAREST);
  }
}

TEST(UsualArithmetic, KeepsSmallNumbersInThisThreadAndThoseThatBeginInIt) {
  _mm_setcsr(_mm_getcsr() | kDropsSmall);
  EXPECT_FALSE(is_usual());
  {
    const UsualArithmetic usual;
    EXPECT_TRUE(is_usual());
    bool in_thread = false;
    std::thread([&] { in_thread = is_usual(); }).join();
    EXPECT_TRUE(in_thread);
  }
  EXPECT_EQ(_mm_getcsr() & kDropsSmall, kDropsSmall);
  _mm_setcsr(_mm_getcsr() & ~kDropsSmall);
}

}  // namespace
}  // namespace geom
