#include "geom/base/error.h"

#include <gtest/gtest.h>

#include <string>
#include <type_traits>

namespace geom {
namespace {

TEST(InputError, SaysSourceAndLineBeforeTheFault) {
  const Fault fault{.expected = "6 fields", .found = "5"};
  EXPECT_STREQ(InputError("boxes.csv", 17, fault).what(),
               "boxes.csv:17: expected 6 fields, found 5");
  EXPECT_STREQ(InputError("city.boxmap", 0, fault).what(),
               "city.boxmap: expected 6 fields, found 5");
  EXPECT_STREQ(InputError("city.boxmap", fault).what(), "city.boxmap: expected 6 fields, found 5");
}

TEST(InputError, KeepsItsFields) {
  const Fault fault{.item = "feature 3",
                    .key = "margin",
                    .says = "",
                    .expected = ">= 0",
                    .found = "-1",
                    .advice = "leave it out"};
  const InputError error("a.json", 2, fault);
  const InputError copy = error;
  EXPECT_EQ(copy.source(), "a.json");
  EXPECT_EQ(copy.line(), 2u);
  EXPECT_EQ(copy.fault(), fault);
  EXPECT_STREQ(copy.what(), "a.json:2: feature 3: margin must be >= 0, found -1: leave it out");
  EXPECT_TRUE(std::is_nothrow_copy_constructible_v<InputError>);
}

TEST(InputError, BecomesAnItemOfAnotherSource) {
  const InputError part("mesh.obj", 7, {.item = "face 1", .expected = "3 vertices", .found = "2"});
  EXPECT_STREQ(InputError("world.sdf", 40, part.as_item()).what(),
               "world.sdf:40: mesh.obj:7: face 1: expected 3 vertices, found 2");
  const InputError whole("mesh.obj", {.says = "it is empty"});
  EXPECT_STREQ(InputError("world.sdf", whole.as_item()).what(), "world.sdf: mesh.obj: it is empty");
}

// All 64 ways to leave fields out.
TEST(Fault, SaysEachFieldOnceAndInOrder) {
  for (int which = 0; which < 64; ++which) {
    const auto text = [&](int bit, const char* word) {
      return std::string((which >> bit & 1) != 0 ? word : "");
    };
    const Fault fault{text(0, "ITEM"),     text(1, "KEY"),   text(2, "SAYS"),
                      text(3, "EXPECTED"), text(4, "FOUND"), text(5, "ADVICE")};
    const std::string said = sentence(fault);
    std::size_t last = 0;
    for (const std::string& word :
         {fault.item, fault.says, fault.expected, fault.found, fault.advice}) {
      if (word.empty()) continue;
      const std::size_t at = said.find(word, last);
      ASSERT_NE(at, std::string::npos) << word << " in " << said;
      last = at + word.size();
    }
    EXPECT_EQ(last, said.size());  // nothing before, between or behind but the marks below
    EXPECT_EQ(said.find(fault.key.empty() ? "expected EXPECTED" : "KEY must be EXPECTED") !=
                  std::string::npos,
              !fault.expected.empty())
        << said;
    for (const char* doubled : {": : ", ", , ", ": , ", ", :"}) {
      EXPECT_EQ(said.find(doubled), std::string::npos) << said;
    }
    EXPECT_FALSE(said.starts_with(':') || said.starts_with(',') || said.ends_with(' ')) << said;
  }
}

TEST(Fault, JoinsItemsFromTheOutside) {
  const Fault ring = within("ring 2", {.says = "it is open"});
  EXPECT_EQ(sentence(within("feature 3", ring)), "feature 3: ring 2: it is open");
}

}  // namespace
}  // namespace geom
