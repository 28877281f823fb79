#include "text/csv_records.h"

#include <gtest/gtest.h>

#include <sstream>

#include "geom/base/error.h"

namespace {

std::vector<std::vector<std::string>> read(const std::string& text) {
  std::istringstream in(text);
  geom::CsvRecords records(in, "t");
  std::vector<std::vector<std::string>> out;
  while (records.next()) out.push_back(records.fields());
  return out;
}

using Rows = std::vector<std::vector<std::string>>;

TEST(CsvRecords, QuotedFieldsHoldCommasQuotesAndLineBreaks) {
  EXPECT_EQ(read("a,\"b, \"\"c\"\"\",d\r\n\"x\ny\",\" z \"\n"),
            (Rows{{"a", "b, \"c\"", "d"}, {"x\ny", " z "}}));
}

TEST(CsvRecords, OtherFieldsAreTrimmedAndEmptyLinesPassedOver) {
  EXPECT_EQ(read("\xef\xbb\xbf"
                 " a , b\n\n \r\nc,"),
            (Rows{{"a", "b"}, {"c", ""}}));
}

TEST(CsvRecords, CommentsStandBeforeTheFirstRecord) {
  EXPECT_EQ(read("\xef\xbb\xbf# made \"by hand\n\n# on a Sunday\na,b\n#1,c\n"),
            (Rows{{"a", "b"}, {"#1", "c"}}));
  EXPECT_EQ(read("# nothing else"), Rows{});
}

TEST(CsvRecords, RefusesQuotesThatDoNotClose) {
  EXPECT_THROW(read("a,\"b\n"), geom::InputError);
  EXPECT_THROW(read("\"a\"b,c\n"), geom::InputError);
}

TEST(CsvRecords, RefusesACarriageReturnAloneOutsideQuotes) {
  EXPECT_EQ(read("a,\"b\rc\"\r\r\nd,e\r"), (Rows{{"a", "b\rc"}, {"d", "e"}}));
  EXPECT_THROW(read("a,b\rc,d\n"), geom::InputError);
  EXPECT_THROW(read("a,\"b\"\rc,d\n"), geom::InputError);
  EXPECT_THROW(read("# a comment\ra,b\nc,d\n"), geom::InputError);
}

}  // namespace
