#include "geom/text/unit_hint.h"

#include <gtest/gtest.h>

namespace geom {
namespace {

TEST(UnitHint, GivesTheNumberInTheUnitOfTheOption) {
  EXPECT_EQ(unit_hint("500mm", "metres added"), "; give metres without the unit, 0.5");
  EXPECT_EQ(unit_hint("50 cm", "metres added"), "; give metres without the unit, 0.5");
  EXPECT_EQ(unit_hint("8m/s", "largest speed, m/s"), "; give m/s without the unit, 8");
  EXPECT_EQ(unit_hint("36km/h", "largest speed, m/s"), "; give m/s without the unit, 10");
  EXPECT_EQ(unit_hint("35°", "largest tilt, degrees"), "; give degrees without the unit, 35");
}

TEST(UnitHint, KnowsWhenTheOptionIsInAnotherUnit) {
  EXPECT_EQ(unit_hint("5s", "metres added"), "; give the number alone, without \"s\"");
  EXPECT_EQ(unit_hint("5m/s", "largest acceleration, m/s2"),
            "; give the number alone, without \"m/s\"");
}

TEST(UnitHint, ReadsADecimalComma) {
  EXPECT_EQ(unit_hint("0,5", "metres added"), "; write 0.5");
  EXPECT_EQ(unit_hint("0,5,1", "metres added"), "");
}

TEST(UnitHint, SaysNothingOfWhatIsNoNumberWithAUnit) {
  for (const char* const text : {"", "abc", "5", "-1", "5 parsecs", ",", "m"}) {
    EXPECT_EQ(unit_hint(text, "metres"), "") << text;
  }
}

}  // namespace
}  // namespace geom
