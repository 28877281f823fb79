#include "geom/text/rounded.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace geom {
namespace {

std::string down(double value) { return fmt::format("{:.4g}", rounded_down(value)); }
std::string up(double value) { return fmt::format("{:.4g}", rounded_up(value)); }

TEST(Rounded, NeverPassesTheNumber) {
  EXPECT_EQ(down(4.37699), "4.376");
  EXPECT_EQ(down(123.49), "123.4");
  EXPECT_EQ(down(99.9999), "99.99");
  EXPECT_EQ(down(0.00012349), "0.0001234");
  EXPECT_EQ(up(0.42231), "0.4224");
  EXPECT_EQ(up(9.99901), "10");
  EXPECT_EQ(up(-1.23456), "-1.234");
  EXPECT_EQ(fmt::format("{:.3g}", rounded_up(0.6781, 3)), "0.679");
}

TEST(Rounded, KeepsWhatIsShort) {
  for (const double value : {0.0, 0.031, 0.523, 41.1, 1.0, 14.0, 100.0, 0.5, 1.234, 7000.0}) {
    EXPECT_NEAR(rounded_down(value), value, 1e-3 * value);
    EXPECT_EQ(down(value), fmt::format("{:.4g}", value));
    EXPECT_EQ(up(value), fmt::format("{:.4g}", value));
  }
}

TEST(Rounded, KeepsToSteps) {
  EXPECT_EQ(fmt::format("{:.1f}", rounded_up_to(41.1, 0.1)), "41.1");
  EXPECT_EQ(fmt::format("{:.1f}", rounded_up_to(41.101, 0.1)), "41.2");
  EXPECT_EQ(fmt::format("{:.2f}", rounded_down_to(1.1699, 0.01)), "1.16");
  EXPECT_EQ(rounded_up_to(0.4, 1), 1);
}

}  // namespace
}  // namespace geom
