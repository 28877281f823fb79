#include "geom/text/json_fields.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/reading.h"

namespace geom {
namespace {

JsonFields fields(const std::string& json) { return {json, "r.jsonl", 7}; }

// That f refuses the record at its source and line, in words that name this.
template <class F>
void expect_refusal(const std::string& json, const F& f, const std::string& named) {
  const std::string said = support::refusal_of([&] { f(fields(json)); });
  EXPECT_TRUE(said.starts_with("r.jsonl:7: ")) << json << ": " << said;
  EXPECT_TRUE(support::says(said, named)) << json << ": " << said;
}

TEST(JsonFields, GiveWhatStandsThere) {
  const JsonFields record = fields(
      R"({"type":"path","id":"q1","n":2.5,"p":[1,2,3],"list":[[1,2,3],[4,5,6]],"none":null})");
  EXPECT_NO_THROW(record.require_type("path"));
  EXPECT_EQ(record.text("id"), "q1");
  EXPECT_EQ(record.text("name", "nobody"), "nobody");
  EXPECT_EQ(record.text("id", "nobody"), "q1");
  EXPECT_EQ(record.number("n"), 2.5);
  EXPECT_EQ(record.number("none"), std::nullopt);
  EXPECT_EQ(record.point("p"), Vec3(1, 2, 3));
  EXPECT_EQ(record.points("list"), (std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_TRUE(record.has("n"));
  EXPECT_FALSE(record.has("none"));
  EXPECT_FALSE(record.has("m"));
}

TEST(JsonFields, RefuseMissingKeysAndOtherTypes) {
  expect_refusal(
      "[1]", [](const JsonFields&) {}, "[1]");
  expect_refusal(R"({"type":"map"})", [](const auto& f) { f.require_type("path"); }, "\"map\"");
  expect_refusal(
      "{}", [](const auto& f) { f.require_type("path"); }, "path");
  expect_refusal(
      "{}", [](const auto& f) { f.text("id"); }, "\"id\"");
  expect_refusal(R"({"id":null})", [](const auto& f) { f.text("id"); }, "\"id\"");
  expect_refusal(R"({"id":3})", [](const auto& f) { f.text("id", "x"); }, "id must be a string");
  expect_refusal(R"({"n":"3"})", [](const auto& f) { f.number("n"); }, "\"3\"");
  expect_refusal(
      "{}", [](const auto& f) { f.point("p"); }, "\"p\"");
  expect_refusal(R"({"p":[1,2]})", [](const auto& f) { f.point("p"); }, "[1,2]");
  expect_refusal(R"({"p":[1,2,"x"]})", [](const auto& f) { f.point("p"); }, "p[2]");
  expect_refusal(
      "{}", [](const auto& f) { f.points("list"); }, "\"list\"");
  expect_refusal(R"({"list":[[1,2,3],4]})", [](const auto& f) { f.points("list"); }, "list[1]");
}

TEST(JsonFields, HoldCoordinatesToTheLargest) {
  EXPECT_EQ(fields(R"({"p":[1e8,-1e8,0]})").point("p"), Vec3(1e8, -1e8, 0));
  expect_refusal(R"({"p":[0,1.0000001e8,0]})", [](const auto& f) { f.point("p"); }, "p[1]");
}

TEST(JsonFields, KnowWordsAndTheirFallback) {
  enum class Size { small, large };
  constexpr Words<Size, 2> kSizes{{{Size::small, "small"}, {Size::large, "large"}}};
  EXPECT_EQ(fields(R"({"size":"large"})").word("size", kSizes, Size::small), Size::large);
  EXPECT_EQ(fields("{}").word("size", kSizes, Size::small), Size::small);
  expect_refusal(R"({"size":"huge"})", [&](const auto& f) { f.word("size", kSizes, Size::small); },
                 "small large");
}

}  // namespace
}  // namespace geom
