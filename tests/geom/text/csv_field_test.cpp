#include "geom/text/csv_field.h"

#include <gtest/gtest.h>

#include <sstream>

#include "geom/text/csv_records.h"
#include "support/random_city.h"

namespace geom {
namespace {

TEST(CsvField, IsQuotedOnlyWhereItMustBe) {
  EXPECT_EQ(csv_field(""), "");
  EXPECT_EQ(csv_field("office block; 3"), "office block; 3");
  EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_field("the \"old\" mill"), "\"the \"\"old\"\" mill\"");
  EXPECT_EQ(csv_field(" a"), "\" a\"");
  EXPECT_EQ(csv_field("a\t"), "\"a\t\"");
  EXPECT_EQ(csv_field("a\nb"), "\"a\nb\"");
  EXPECT_EQ(csv_field("a\rb"), "\"a\rb\"");
}

TEST(CsvField, ComesBackFromALine) {
  support::Random random(1);
  for (int i = 0; i < 2000; ++i) {
    std::string text;
    for (int k = random.below(8); k > 0; --k) text += "ab ,\"\t\r\n;"[random.below(9)];
    std::istringstream line(csv_field(text) + ",end\n");
    CsvRecords records(line, "t");
    ASSERT_TRUE(records.next());
    ASSERT_EQ(records.fields(), (std::vector<std::string>{text, "end"})) << "seed 1, case " << i;
  }
}

}  // namespace
}  // namespace geom
