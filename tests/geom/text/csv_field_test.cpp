#include "geom/text/csv_field.h"

#include <gtest/gtest.h>

#include <sstream>

#include "support/random_city.h"
#include "text/csv_records.h"

namespace geom {
namespace {

TEST(CsvField, IsQuotedOnlyWhereItMustBe) {
  for (const char* plain : {"", "office block; 3"}) EXPECT_EQ(csv_field(plain), plain);
  for (const std::string text : {"a,b", " a", "a\t", "a\nb", "a\rb"}) {
    EXPECT_EQ(csv_field(text), '"' + text + '"');
  }
  EXPECT_EQ(csv_field("the \"old\" mill"), "\"the \"\"old\"\" mill\"");
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
