#include "geom/base/skipped.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

namespace {

TEST(Skipped, NamesTheFirstOfEachKind) {
  geom::Skipped skipped;
  EXPECT_TRUE(skipped.empty());
  for (int i = 1; i <= 5; ++i) skipped.add("b", fmt::format("line {}", i));
  skipped.add("a", "x");
  EXPECT_EQ(skipped.count(), 6u);
  EXPECT_EQ(skipped.text(), "1 x a (x), 5 x b (line 1, line 2, line 3, …)");
}

TEST(Skipped, SaysOfWhichFileItIs) {
  geom::Skipped part;
  part.add("a", "line 7");
  geom::Skipped whole;
  whole.add("a", "line 2");
  whole.add_of("b.obj", part);
  whole.add_of("c.obj", part);
  EXPECT_EQ(whole.text(), "3 x a (line 2, b.obj: line 7, c.obj: line 7)");
  EXPECT_EQ(part.text(), "1 x a (line 7)");
}

TEST(Skipped, NamesOneOfEachWhereThereAreManyKinds) {
  geom::Skipped skipped;
  for (char kind = 'a'; kind <= 'm'; ++kind) {
    skipped.add(std::string(1, kind), "first");
    skipped.add(std::string(1, kind), "second");
  }
  skipped.add("m", "third");
  EXPECT_TRUE(skipped.text().starts_with("3 x m (first, …), 2 x a (first, …)")) << skipped.text();
  EXPECT_TRUE(skipped.text().ends_with("2 x g (first, …) and 10 of 5 more kinds"))
      << skipped.text();
  EXPECT_EQ(skipped.by_kind().at("m"), 3u);
  EXPECT_EQ(skipped.by_kind().size(), 13u);
}

}  // namespace
