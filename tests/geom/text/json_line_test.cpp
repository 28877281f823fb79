#include "geom/text/json_line.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "geom/base/random.h"
#include "geom/base/vec3.h"
#include "geom/text/parse_json.h"

namespace geom {
namespace {

using Json = nlohmann::ordered_json;

TEST(JsonLine, IsEmptyUntilAMemberIsAdded) {
  JsonLine line;
  EXPECT_TRUE(line.empty());
  EXPECT_TRUE(line.add("a", std::optional<int>()).empty());
  EXPECT_FALSE(line.add("a", JsonLine()).empty());
}

TEST(JsonLine, WritesValuesOfEachType) {
  EXPECT_EQ(JsonLine().add("v", true).add("w", false).object(), R"({"v":true,"w":false})");
  EXPECT_EQ(JsonLine().add("v", nullptr).object(), R"({"v":null})");
  EXPECT_EQ(JsonLine().add("v", std::uint8_t{65}).object(), R"({"v":65})");
  EXPECT_EQ(JsonLine().add("v", std::numeric_limits<std::uint64_t>::max()).object(),
            R"({"v":18446744073709551615})");
  EXPECT_EQ(JsonLine().add("v", std::numeric_limits<std::int64_t>::min()).object(),
            R"({"v":-9223372036854775808})");
  EXPECT_EQ(JsonLine().add("v", 0.1).add("w", -0.0).add("x", 1e300).object(),
            R"({"v":0.1,"w":-0,"x":1e+300})");
  EXPECT_EQ(JsonLine().add("v", std::string("a")).add("w", std::string_view("b")).object(),
            R"({"v":"a","w":"b"})");
  EXPECT_EQ(JsonLine().add("v", Vec3(1, 2.5, -3)).object(), R"({"v":[1,2.5,-3]})");
}

TEST(JsonLine, WritesWhatIsNotFiniteAsNull) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::vector<double> values{kInfinity, -kInfinity, std::numeric_limits<double>::quiet_NaN(),
                                   0.5};
  EXPECT_EQ(JsonLine().add("v", values).object(), R"({"v":[null,null,null,0.5]})");
}

TEST(JsonLine, LeavesOutAbsentMembersButNotAbsentItems) {
  const std::optional<double> absent;
  EXPECT_EQ(JsonLine().add("a", absent).add("b", std::optional(2.0)).object(), R"({"b":2})");
  EXPECT_EQ(JsonLine().add("a", std::vector{absent, std::optional(2.0)}).object(),
            R"({"a":[null,2]})");
}

TEST(JsonLine, WritesTuplesAsLists) {
  EXPECT_EQ(JsonLine().add("a", std::tuple(1, "x", Vec3(0, 0, 1), JsonLine())).object(),
            R"({"a":[1,"x",[0,0,1],{}]})");
  EXPECT_EQ(JsonLine().add("a", std::tuple()).object(), R"({"a":[]})");
}

TEST(JsonLine, ListsWhatIsMadeOfEachItem) {
  struct Item {
    int number;
  };
  const std::array<Item, 2> items{{{1}, {2}}};
  EXPECT_EQ(JsonLine().add("a", items, &Item::number).object(), R"({"a":[1,2]})");
  const auto object = [](const Item& item) { return JsonLine().add("n", item.number); };
  EXPECT_EQ(JsonLine().add("a", items, object).object(), R"({"a":[{"n":1},{"n":2}]})");
  EXPECT_EQ(JsonLine().add("a", std::vector<Item>(), object).object(), R"({"a":[]})");
}

TEST(JsonLine, TakesJsonAsItIs) {
  EXPECT_EQ(JsonLine().add("a", 1).add_json("b", R"({"c":[]})").add("d", 2).object(),
            R"({"a":1,"b":{"c":[]},"d":2})");
}

TEST(JsonLine, EscapesTextsAndKeys) {
  EXPECT_EQ(JsonLine().add("a\"b", "\"\\/\n\t\x01\x7f").object(),
            "{\"a\\\"b\":\"\\\"\\\\/\\n\\t\\u0001\x7f\"}");
  EXPECT_EQ(JsonLine().add("a", "Zürich").object(), R"({"a":"Zürich"})");
}

TEST(JsonLine, ReplacesWhatIsNotUtf8) {
  EXPECT_EQ(JsonLine().add("a", "x\xffy").object(), "{\"a\":\"x\xef\xbf\xbdy\"}");
}

// The same value as a line writes it and as nlohmann holds it.
struct Both {
  JsonLine line;
  Json json = Json::object();
};

std::string random_text(SplitMix64& random) {
  static const std::array<std::string, 8> kPieces = {"a", "\"", "\\", "{", "[,", "é", "\n", "\x1f"};
  std::string text;
  for (int n = random.whole(0, 6); n > 0; --n) text += kPieces[random.whole(0, 7)];
  return text;
}

// From denormals to the largest.
double random_number(SplitMix64& random) {
  return random.uniform(-1, 1) * std::pow(10.0, random.whole(-310, 307));
}

Both random_object(SplitMix64& random, int depth) {
  Both both;
  const auto add = [&](const std::string& key, const auto& value) {
    both.line.add(key, value);
    both.json[key] = value;
  };
  for (int n = random.whole(0, 5); n > 0; --n) {
    const std::string key = std::to_string(n) + random_text(random);
    switch (random.whole(0, depth > 0 ? 7 : 5)) {
      case 0:
        add(key, random_number(random));
        break;
      case 1:
        add(key, random_text(random));
        break;
      case 2:
        add(key, random.whole(-1000, 1000));
        break;
      case 3:
        add(key, random.chance(0.5));
        break;
      case 4:
        add(key, nullptr);
        break;
      case 5:
        add(key, std::vector<double>(random.whole(0, 3), random_number(random)));
        break;
      case 6: {
        const Both inner = random_object(random, depth - 1);
        both.line.add(key, inner.line);
        both.json[key] = inner.json;
        break;
      }
      default: {
        std::vector<JsonLine> lines;
        both.json[key] = Json::array();
        for (int items = random.whole(0, 3); items > 0; --items) {
          const Both item = random_object(random, depth - 1);
          lines.push_back(item.line);
          both.json[key].push_back(item.json);
        }
        both.line.add(key, lines);
      }
    }
  }
  return both;
}

TEST(JsonLine, ReadsBackAsWhatWasAdded) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    SplitMix64 random(seed);
    const Both both = random_object(random, 4);
    const std::string line = both.line.line();
    ASSERT_EQ(line.find('\n'), line.size() - 1) << "seed " << seed << ": " << line;
    ASSERT_EQ(parse_ordered_json(line, "line"), both.json) << "seed " << seed << ": " << line;
  }
}

}  // namespace
}  // namespace geom
