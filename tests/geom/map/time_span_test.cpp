#include "geom/map/time_span.h"

#include <gtest/gtest.h>

#include <cmath>

namespace geom {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(TimeSpan, IsClosedAtBothEnds) {
  const TimeSpan span{10, 20};
  EXPECT_TRUE(span.meets({20, 30}) && span.meets({0, 10}) && span.meets({12, 12}));
  EXPECT_FALSE(span.meets({std::nextafter(20.0, 30), 30}) || span.meets({0, 9.999}));
  EXPECT_TRUE(TimeSpan().meets(span) && span.meets({-kInfinity, 10}) &&
              span.meets({20, kInfinity}));
  EXPECT_FALSE(span.meets({kNaN, kNaN}));
  EXPECT_TRUE(TimeSpan().contains(span) && span.contains({10, 20}));
  EXPECT_FALSE(span.contains({10, 20.5}) || span.contains({}));
  EXPECT_TRUE(TimeSpan().always());
  EXPECT_FALSE((TimeSpan{-kInfinity, 5}).always());
}

TEST(TimeSpan, MustBeOne) {
  EXPECT_FALSE(span_fault({}) || span_fault({-kInfinity, 3}) || span_fault({3, 3}) ||
               span_fault({-1e9, 1e9}));
  for (const TimeSpan& bad :
       {TimeSpan{kNaN, 1}, TimeSpan{0, kNaN}, TimeSpan{2, 1}, TimeSpan{kInfinity, kInfinity},
        TimeSpan{-kInfinity, -kInfinity}, TimeSpan{-1.1e9, 0}, TimeSpan{0, 1.1e9}}) {
    EXPECT_TRUE(span_fault(bad)) << bad.from << ' ' << bad.until;
  }
  EXPECT_EQ(sentence(*span_fault({2, 1})), "from must be at most until, found 2 and 1");
}

}  // namespace
}  // namespace geom
