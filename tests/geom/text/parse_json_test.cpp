#include "geom/text/parse_json.h"

#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>

#include "geom/base/error.h"
#include "geom/collision/collision.h"
#include "geom/import/import_boxes.h"
#include "geom/import/keep_out.h"
#include "geom/map/frame.h"
#include "geom/record/query_record.h"
#include "geom/record/record.h"
#include "geom/text/json_fields.h"
#include "import/city_json.h"
#include "support/reading.h"

namespace geom {
namespace {

std::string refused(std::string_view text, std::size_t line = 0) {
  const std::string ordered = support::refusal_of([&] { parse_ordered_json(text, "f"); });
  const std::string message = support::refusal_of([&] { parse_json(text, "f", line); });
  if (line == 0) {
    EXPECT_EQ(message, ordered);
  }
  return message;
}

std::string nested(std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); }

TEST(ParseJson, ReadsEveryKindOfValue) {
  const char* const text = R"( {"a":[1,-2,3.5,1e3,true,null,"x\u00e9\n"],"b":{}} )";
  EXPECT_EQ(parse_json(text, "f").dump(), R"({"a":[1,-2,3.5,1000.0,true,null,"xé\n"],"b":{}})");
  EXPECT_EQ(parse_ordered_json(R"({"b":1,"a":{"d":2,"c":3}})", "f").dump(),
            R"({"b":1,"a":{"d":2,"c":3}})");
  EXPECT_EQ(parse_json("null", "f"), nullptr);
  EXPECT_EQ(parse_json("18446744073709551615", "f").get<std::uint64_t>(), ~std::uint64_t{0});
  EXPECT_EQ(parse_json("\xef\xbb\xbf[1]", "f").dump(), "[1]");  // a byte order mark
}

TEST(ParseJson, ReadsAStream) {
  std::istringstream in("[1,\n2]");
  EXPECT_EQ(parse_json(in, "f").size(), 2u);
}

TEST(ParseJson, RefusesWhatIsNestedTooDeep) {
  EXPECT_EQ(parse_json(nested(kDeepestJson), "f").size(), 1u);
  EXPECT_EQ(refused(nested(kDeepestJson + 1)),
            "f:1: column 101: expected lists and objects nested at most 100 deep, found more");
  EXPECT_NE(refused(nested(75000)), "");
  EXPECT_NE(refused(std::string(75000, '[')), "");
  std::string objects;
  for (int i = 0; i < 75000; ++i) objects += "{\"a\":";
  EXPECT_NE(refused(objects), "");
}

TEST(ParseJson, RefusesAKeyThatComesTwice) {
  EXPECT_EQ(refused(R"({"margin":1,"margin":0})"),
            "f:1: column 13: expected each key once, found \"margin\" again");
  EXPECT_EQ(refused("{\"a\":{\"b\":1,\n\"\\u0062\":2}}"),
            "f:2: column 1: expected each key once, found \"b\" again");
  EXPECT_EQ(refused(R"([{"a":1},{"a":1}])"), "");
}

TEST(ParseJson, RefusesNumbersBeyondADouble) {
  EXPECT_EQ(refused("[1,1e999]"),
            "f:1: column 4: expected a number that a double holds (up to 1.8e308), found 1e999");
  EXPECT_NE(refused("-1e400"), "");
  EXPECT_NE(refused(std::string(400, '9')), "");
  for (const char* const word : {"NaN", "Infinity", "-inf", "+1", ".5", "1.", "0x10", "01"}) {
    EXPECT_NE(refused(word), "") << word;
  }
}

TEST(ParseJson, SaysWhereAndWhatWasExpected) {
  EXPECT_EQ(refused(""), "f:1: column 1: this is not JSON: expected a value, found the end");
  EXPECT_EQ(refused("lat0 37"), "f:1: column 1: this is not JSON: expected a value, found lat0");
  EXPECT_EQ(refused("{} x"),
            "f:1: column 4: this is not JSON: expected nothing after the value, found x");
  EXPECT_EQ(refused("{\"a\":1}\n{\"b\":2}"),
            "f:2: column 1: this is not JSON: expected nothing after the value, found {\"b\"");
  EXPECT_EQ(refused("[1 2]"), "f:1: column 4: this is not JSON: expected , or ], found 2");
  EXPECT_EQ(refused("[1,]"), "f:1: column 4: this is not JSON: expected a value, found ]");
  EXPECT_EQ(refused("[1"), "f:1: column 3: this is not JSON: expected , or ], found the end");
  EXPECT_EQ(refused("[}"), "f:1: column 2: this is not JSON: expected a value or ], found }");
  EXPECT_EQ(refused("{1:2}"),
            "f:1: column 2: this is not JSON: expected a key in quotes or }, found 1");
  EXPECT_EQ(refused(R"({"a" 1})"),
            "f:1: column 6: this is not JSON: expected : after the key, found 1");
  EXPECT_EQ(refused(R"({"a":})"), "f:1: column 6: this is not JSON: expected a value, found }");
  EXPECT_EQ(refused(R"({"a":1 "b":2})"),
            "f:1: column 8: this is not JSON: expected , or }, found \"b\"");
  EXPECT_EQ(refused("{\n \"a\":1,\n}"),
            "f:3: column 1: this is not JSON: expected a key in quotes, found }");
  EXPECT_EQ(refused("[1,", 17),
            "f:17: column 4: this is not JSON: expected a value, found the end");
}

TEST(ParseJson, RefusesStringsThatAreNone) {
  for (const std::string& text :
       {std::string("\"abc"), std::string("\"a\nb\""), std::string("\"\xff\""),
        std::string("\"\\q\""), std::string("\"\\ud800\"")}) {
    EXPECT_TRUE(support::says(refused(text), "expected a string in UTF-8"));
  }
}

TEST(ParseJson, ShowsLittleOfWhatStood) {
  const std::string long_text = "\"" + std::string(1 << 20, 'x');
  EXPECT_LT(refused(long_text).size(), 200u);
  EXPECT_LT(
      refused("{\"" + std::string(1 << 20, 'k') + "\":1,\"" + std::string(1 << 20, 'k') + "\":2}")
          .size(),
      200u);
  EXPECT_FALSE(support::says(refused("[\x1b[2J]"), "\x1b"));
  EXPECT_EQ(shown(parse_json(R"({"b":[1,2],"a":"x"})", "f")), R"({"a":"x","b":[1,2]})");
  EXPECT_LE(shown(parse_json("[" + std::string(999, ' ') +
                                 "1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,"
                                 "16,17,18,19,20,21,22,23,24,25,26,27,28,29,30]",
                             "f"))
                .size(),
            60u);
  EXPECT_EQ(shown(parse_json("\"a\\u001b\\u009b\"", "f")), "\"a\\u001b\\u009b\"");
}

// No reader crashes on what is nested deep, and none lets a word of the parser's library out.
TEST(ParseJson, IsWhatEveryReaderUses) {
  const Frame frame{Axes::enu, GeodeticOrigin{60, 25, 0}, ""};
  const auto streamed = [](const auto& read) {
    return [read](const std::string& text) { read(support::Text(text)); };
  };
  const std::pair<const char*, std::function<void(const std::string&)>> readers[] = {
      {"fields", [](const std::string& text) { JsonFields(text, "f", 1); }},
      {"path", [](const std::string& text) { parse_path_record(text, "f", 1); }},
      {"world", streamed([](std::istream& in) { import_boxes(in, kRotorPyWorld, "f"); })},
      {"city", streamed([](std::istream& in) { read_city_json(in, "f"); })},
      {"keep-out", streamed([&](std::istream& in) { read_keep_out(in, "f", frame, {}); })},
      {"queries", streamed([](std::istream& in) { read_plan_queries(in, "f"); })}};
  const std::string deep = "{\"type\":" + nested(75000) + "}";
  for (const auto& [name, read] : readers) {
    for (const std::string& text :
         {deep, "{\"id\":" + deep + "}", std::string("{\"type\":1,\"type\":2}"),
          std::string("{\"type\":1e999}"), std::string("{\"type\":"), std::string("{} {}")}) {
      const std::string message = support::refusal_of([&] { read(text); });
      EXPECT_TRUE(message.starts_with("f:1: column ")) << name << ": " << message;
      EXPECT_FALSE(support::says(message, "exception")) << name << ": " << message;
    }
  }
}

TEST(ParseJson, ReadsPastNoByteOfZero) {
  EXPECT_EQ(refused({"{}\0{}", 5}),
            "f:1: column 3: this is not JSON: expected nothing after the value, found \\x00{");
  EXPECT_NE(refused({"[1\0]", 4}), "");
  EXPECT_NE(refused({"\0", 1}), "");
}

}  // namespace
}  // namespace geom
