#include "geom/text/csv_records.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "geom/base/error.h"
#include "geom/import/box_csv.h"
#include "geom/text/csv_field.h"

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

TEST(CsvRecords, RefusesQuotesThatDoNotClose) {
  EXPECT_THROW(read("a,\"b\n"), geom::InputError);
  EXPECT_THROW(read("\"a\"b,c\n"), geom::InputError);
}

TEST(BoxCsv, LabelsOfAnyBytesComeBack) {
  std::mt19937 random(1);
  geom::BoxTable table;
  const auto add = [&](const std::string& label) {
    table.labels.push_back(label);
    table.boxes.push_back({geom::Vec3::Zero(), geom::Vec3::Ones()});
    table.ids.push_back(0);
    table.label.push_back(static_cast<std::uint32_t>(table.labels.size() - 1));
  };
  for (int byte = 0; byte < 256; ++byte) {
    const char c = static_cast<char>(byte);
    add(std::string("[") + c);
    add(c + std::string("]"));
    add(std::string("a") + c + "b " + static_cast<char>(255 - byte));
  }
  for (int i = 0; i < 10000; ++i) {
    std::string label = fmt::format("{}", i);
    for (std::size_t k = random() % 12; k > 0; --k) label += static_cast<char>(random());
    add(label);
  }
  std::stringstream text;
  geom::write_box_csv(text, table);
  const geom::BoxTable back = geom::read_box_csv(text, "t");
  ASSERT_EQ(back.boxes.size(), table.boxes.size());
  for (std::size_t i = 0; i < table.boxes.size(); ++i) {
    ASSERT_EQ(back.labels[back.label[i]], table.labels[table.label[i]]) << "label " << i;
  }
}

TEST(BoxCsv, RefusesWhatNoDoubleHoldsAndReadsWhatIsTiny) {
  const std::string header = "min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label\n";
  std::istringstream tiny(header + "-1e-400,1e-400,0,1,1,1,\n");
  EXPECT_EQ(geom::read_box_csv(tiny, "t").boxes.front().min, geom::Vec3::Zero());
  std::istringstream large(header + "-1e400,0,0,1,1,1,\n");
  EXPECT_THROW(geom::read_box_csv(large, "t"), geom::InputError);
}

}  // namespace
