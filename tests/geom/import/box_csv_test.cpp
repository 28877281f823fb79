#include "geom/import/box_csv.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "geom/base/error.h"

namespace geom {
namespace {

TEST(BoxCsv, ComesBackBitForBit) {
  std::istringstream in(
      "min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label\n"
      "0.1,-0,1e-300,0.30000000000000004,2,3,\"a \"\"b\"\", c\"\n");
  const BoxTable table = read_box_csv(in, "b.csv");
  EXPECT_EQ(table.labels[1], "a \"b\", c");
  std::ostringstream once;
  write_box_csv(once, table);
  std::istringstream again(once.str());
  const BoxTable back = read_box_csv(again, "b.csv");
  EXPECT_EQ(back.boxes[0], table.boxes[0]);
  EXPECT_EQ(back.labels, table.labels);
}

TEST(BoxCsv, LabelsOfAnyBytesComeBack) {
  std::mt19937 random(1);
  BoxTable table;
  const auto add = [&](const std::string& label) {
    table.labels.push_back(label);
    table.boxes.push_back({Vec3::Zero(), Vec3::Ones()});
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
  write_box_csv(text, table);
  const BoxTable back = read_box_csv(text, "t");
  ASSERT_EQ(back.boxes.size(), table.boxes.size());
  for (std::size_t i = 0; i < table.boxes.size(); ++i) {
    ASSERT_EQ(back.labels[back.label[i]], table.labels[table.label[i]]) << "label " << i;
  }
}

TEST(BoxCsv, RefusesWhatNoDoubleHoldsAndReadsWhatIsTiny) {
  const std::string header = "min_x_m,min_y_m,min_z_m,max_x_m,max_y_m,max_z_m,label\n";
  std::istringstream tiny(header + "-1e-400,1e-400,0,1,1,1,\n");
  EXPECT_EQ(read_box_csv(tiny, "t").boxes.front().min, Vec3::Zero());
  std::istringstream large(header + "-1e400,0,0,1,1,1,\n");
  EXPECT_THROW(read_box_csv(large, "t"), InputError);
}

}  // namespace
}  // namespace geom
