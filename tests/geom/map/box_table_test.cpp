#include "geom/map/box_table.h"

#include <gtest/gtest.h>

namespace geom {
namespace {

Aabb unit(double x) { return {{x, 0, 0}, {x + 1, 1, 1}}; }

TEST(BoxTable, KeepsALabelOnce) {
  BoxTable table;
  EXPECT_EQ(table.label_of(""), 0u);
  EXPECT_EQ(table.label_of("church"), 1u);
  EXPECT_EQ(table.label_of("mast"), 2u);
  EXPECT_EQ(table.label_of("church"), 1u);
  table.labels.push_back("tower");  // by hand, as readers of maps do
  EXPECT_EQ(table.label_of("tower"), 3u);
  EXPECT_EQ(table.labels, (std::vector<std::string>{"", "church", "mast", "tower"}));
}

TEST(BoxTable, KeepsTheTimesOfBoxesWhateverBecomesOfThem) {
  BoxTable table;
  for (int i = 0; i < 6; ++i) table.add(unit(i), 10 + i);
  table.set_time(1, {1, 2});
  table.set_time(3, {3, 4});
  table.boxes.push_back(unit(9));  // by hand
  table.ids.push_back(19);
  table.label.push_back(0);
  EXPECT_TRUE(table.time(0).always() && table.time(6).always());
  BoxTable kept = table;
  kept.keep_if([](std::size_t i) { return i != 1 && i != 2; });  // 10, 13, 14, 15, 19
  EXPECT_TRUE(kept.time(0).always() && kept.time(2).always() && kept.time(4).always());
  EXPECT_EQ(kept.time(1), (TimeSpan{3, 4}));
  BoxTable last = table;
  last.keep_if([](std::size_t i) { return i >= 4; });
  EXPECT_TRUE(last.time(0).always() && last.time(1).always() && last.time(2).always());
  BoxTable more;
  more.add(unit(20), 30);
  append(more, table);
  append(more, last);
  EXPECT_TRUE(more.time(0).always() && more.time(1).always() && more.time(8).always());
  EXPECT_EQ(more.time(2), (TimeSpan{1, 2}));
  EXPECT_EQ(more.time(4), (TimeSpan{3, 4}));
}

TEST(BoxTable, KeepsWhatIsAskedForInItsOrder) {
  BoxTable table;
  for (int i = 0; i < 6; ++i) table.add(unit(i), 10 + i, table.label_of(i % 2 ? "odd" : "even"));
  table.keep_if([](std::size_t i) { return i % 3 != 0; });
  EXPECT_EQ(table.ids, (std::vector<std::uint64_t>{11, 12, 14, 15}));
  EXPECT_EQ(table.label, (std::vector<std::uint32_t>{2, 1, 1, 2}));
  EXPECT_EQ(table.boxes[2], unit(4));
  table.keep_if([](std::size_t) { return false; });
  EXPECT_TRUE(table.boxes.empty() && table.ids.empty() && table.label.empty());
}

TEST(BoxTable, AppendedLabelsAreThoseOfTheSameText) {
  BoxTable a;
  a.add(unit(0), 1, a.label_of("church"));
  BoxTable b;
  b.add(unit(2), 7, b.label_of("mast"));
  b.add(unit(4), 8, b.label_of("church"));
  b.add(unit(6), 9);
  append(a, b);
  EXPECT_EQ(a.labels, (std::vector<std::string>{"", "church", "mast"}));
  EXPECT_EQ(a.label, (std::vector<std::uint32_t>{1, 2, 1, 0}));
  EXPECT_EQ(a.ids, (std::vector<std::uint64_t>{1, 7, 8, 9}));
}

}  // namespace
}  // namespace geom
