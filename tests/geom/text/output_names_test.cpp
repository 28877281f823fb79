#include "geom/text/output_names.h"

#include <gtest/gtest.h>

#include "geom/base/usage_error.h"
#include "support/reading.h"

namespace geom {
namespace {

TEST(SafeName, KeepsLettersDigitsAndMarksAndNothingElse) {
  EXPECT_EQ(safe_name("Flight-1_a.b"), "Flight-1_a.b");
  EXPECT_EQ(safe_name("a/b c"), "a_b_c");
  EXPECT_EQ(safe_name(".."), "_.");
  EXPECT_EQ(safe_name(""), "_");
  EXPECT_EQ(safe_name(std::string(300, 'x')).size(), 100u);
}

TEST(OutputNames, PutTheIdInPlaceOfTheMark) {
  OutputNames names("out/%s.csv", "--output");
  EXPECT_TRUE(names.each());
  EXPECT_EQ(names.of("a b", "r"), "out/a_b.csv");
}

TEST(OutputNames, AreOneFileForAllWithoutAMark) {
  OutputNames names("out.csv", "--output");
  EXPECT_FALSE(names.each());
  EXPECT_EQ(names.of("a", "r"), "out.csv");
  EXPECT_EQ(names.of("b", "r"), "out.csv");
}

TEST(OutputNames, RefuseTwoMarks) {
  EXPECT_THROW(OutputNames("%s/%s.csv", "--output"), UsageError);
}

TEST(OutputNames, RefuseIdsThatWouldBeOneFileOnSomeDrive) {
  OutputNames names("%s.csv", "--output");
  names.of("tower", "r");
  EXPECT_EQ(support::refusal_of([&] { names.of("Tower", "r"); }).find("r: expected ids"), 0u);
  OutputNames marks("%s.csv", "--output");
  marks.of("a b", "r");
  EXPECT_NE(support::refusal_of([&] { marks.of("a_b", "r"); }), "");
}

}  // namespace
}  // namespace geom
