#include "import/sdf/sdf_node.h"

#include <gtest/gtest.h>

#include "support/reading.h"

namespace geom {
namespace {

struct Parsed {
  explicit Parsed(const std::string& text) : root(parse_xml(text, "w.sdf")) {}
  XmlElement root;
  std::string source = "w.sdf";
  SdfNode node() const { return {&root, &source}; }
};

TEST(SdfNode, FindsOneChildOfNoNamespace) {
  const Parsed a("<a><b/><k:b/><c>1</c><c>2</c></a>");
  EXPECT_EQ(a.node().find("b")->name(), "b");
  EXPECT_FALSE(a.node().find("d"));
  EXPECT_EQ(a.node().all("c").size(), 2u);
  EXPECT_TRUE(
      support::says(support::refusal_of([&] { a.node().find("c"); }), "expected one <c> in <a>"));
  EXPECT_EQ(support::refusal_of([&] { a.node().child("d"); }),
            "w.sdf:1: expected <d> in <a>, found none");
}

TEST(SdfNode, ReadsNumbersWithoutUnits) {
  EXPECT_EQ(Parsed("<a> 1 -2.5\n+3e2 </a>").node().numbers(3), (std::vector<double>{1, -2.5, 300}));
  for (const char* bad : {"1 2", "1 2 3 4", "1 2 3m", "1 2 nan", "1 2 inf", "1 2 1e9", "1,2,3",
                          "1 2 +-3", "1 2 ++3", "", "1 2 0x3"}) {
    const Parsed a("<a>" + std::string(bad) + "</a>");
    EXPECT_NE(support::refusal_of([&] { a.node().numbers(3); }), "") << bad;
  }
  EXPECT_NE(support::refusal_of([] { Parsed("<a>-1</a>").node().not_negative(1); }), "");
  EXPECT_NE(support::refusal_of([] { Parsed("<a>0</a>").node().number_above_zero(); }), "");
}

TEST(SdfNode, ReadsFlags) {
  EXPECT_TRUE(Parsed("<a>true</a>").node().flag());
  EXPECT_TRUE(Parsed("<a> 1 </a>").node().flag());
  EXPECT_FALSE(Parsed("<a>false</a>").node().flag());
  EXPECT_FALSE(Parsed("<a>0</a>").node().flag());
  EXPECT_NE(support::refusal_of([] { Parsed("<a>yes</a>").node().flag(); }), "");
}

}  // namespace
}  // namespace geom
