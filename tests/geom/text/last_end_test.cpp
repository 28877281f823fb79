#include "geom/text/last_end.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "geom/base/error.h"
#include "geom/text/parse_json.h"

namespace geom {
namespace {

std::string kept(const std::string& lines) { return lines.substr(0, up_to_last_end(lines)); }

TEST(LastEnd, IsFromTheLastCommaTabOrSpaceOfTheLastLineOn) {
  EXPECT_EQ(kept("a,b\n1,2\n"), "a,b\n1");
  EXPECT_EQ(kept("1\t2\t3\n"), "1\t2");
  EXPECT_EQ(kept("1 2 3\n"), "1 2");
  EXPECT_EQ(kept("1,2,3"), "1,2");  // the end of the line is still to come
}

TEST(LastEnd, IsTheLastCharacterOfALineWithoutThose) {
  EXPECT_EQ(kept("{\"a\":1}\n{\"b\":2}\n"), "{\"a\":1}\n{\"b\":2");
  EXPECT_EQ(kept("a,b\n\n"), "a,b\n");
  EXPECT_EQ(kept("ab"), "");
  EXPECT_EQ(kept("\n"), "");
  EXPECT_EQ(kept(""), "");
}

TEST(LastEnd, LeavesNoRecordThatLooksWhole) {
  for (const std::string record :
       {R"({"id":"q"})", R"({"id":1})", "{}", R"({"id":"a, b","x":[1,2]})", R"([1,2])"}) {
    EXPECT_THROW(parse_json(kept(record + "\n"), "lines"), InputError) << record;
  }
}

}  // namespace
}  // namespace geom
