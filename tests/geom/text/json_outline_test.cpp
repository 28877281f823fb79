#include "text/json_outline.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "geom/base/error.h"

namespace geom {
namespace {

using Json = nlohmann::json;

TEST(JsonOutline, EmptiesWhatIsDeeper) {
  const char* const text = R"({"a":1,"b":[{"c":[2,3]},4],"d":{"e":{"f":5}}})";
  EXPECT_EQ(json_outline(text, "x", 1), Json::parse(R"({"a":1,"b":[],"d":{}})"));
  EXPECT_EQ(json_outline(text, "x", 2), Json::parse(R"({"a":1,"b":[{},4],"d":{"e":{}}})"));
  EXPECT_EQ(json_outline(text, "x", 9), Json::parse(text));
  EXPECT_EQ(json_outline("7", "x", 0), Json(7));
}

TEST(JsonOutline, LooksAtWhatItEmpties) {
  for (const char* wrong : {R"({"a":[{"b":1,"b":2}]})", R"({"a":[1,]})", R"({"a":[1e999]})",
                            R"({"a":[1]} 2)", R"({"a":[1)"}) {
    EXPECT_THROW(json_outline(wrong, "x", 0), InputError) << wrong;
  }
}

}  // namespace
}  // namespace geom
