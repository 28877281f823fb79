#include "geom/base/format.h"

#include <gtest/gtest.h>

#include <string>

namespace geom {
namespace {

constexpr std::string_view kReaders[] = {"skyway-cloud"};
constexpr Format kPcd{.word = "pcd",
                      .what = "a PCD point cloud",
                      .begins = [](std::string_view head) { return head.starts_with("# .PCD"); },
                      .readers = kReaders};
constexpr Format kComment{.what = "a text",
                          .begins = [](std::string_view head) { return head.starts_with("#"); }};
constexpr Format kXyz{.word = "xyz", .what = "a table of points"};
constexpr const Format* kTable[] = {&kPcd, &kComment, &kXyz};

TEST(Recognise, TakesTheFirstThatFits) {
  EXPECT_EQ(recognise("# .PCD v0.7\n", kTable), &kPcd);
  EXPECT_EQ(recognise("# 1 2 3\n", kTable), &kComment);
}

TEST(Recognise, FindsNothingThatNoBeginningTells) {
  EXPECT_EQ(recognise("1 2 3\n", kTable), nullptr);
  EXPECT_EQ(recognise("", {}), nullptr);
}

TEST(Recognise, LooksAtTheHeadAlone) {
  static constexpr Format late{
      .what = "late", .begins = [](std::string_view head) { return head.find('!') != head.npos; }};
  static constexpr const Format* table[] = {&late};
  const std::string blanks(kFormatHead, ' ');
  EXPECT_EQ(recognise(blanks.substr(1) + "!", table), &late);
  EXPECT_EQ(recognise(blanks + "!", table), nullptr);
}

TEST(FormatNamed, FindsWordsAndNoEmptyOne) {
  EXPECT_EQ(format_named("xyz", kTable), &kXyz);
  EXPECT_EQ(format_named("las", kTable), nullptr);
  EXPECT_EQ(format_named("", kTable), nullptr);
}

struct Row {
  const Format* format;
  Formats kinds = {};
  bool (*may_be)(std::string_view head) = nullptr;
};
constexpr const Format* kKinds[] = {&kComment};
constexpr Row kPcdRow{.format = &kPcd, .kinds = kKinds};
constexpr Row kXyzRow{.format = &kXyz,
                      .may_be = [](std::string_view head) { return head.starts_with("1"); }};
constexpr const Row* kRows[] = {&kPcdRow, &kXyzRow};

TEST(FormatRows, AreFoundByTheirWords) {
  EXPECT_EQ(row_named<Row>("xyz", kRows), &kXyzRow);
  EXPECT_EQ(row_named<Row>("las", kRows), nullptr);
  EXPECT_EQ(row_named<Row>("", kRows), nullptr);
  EXPECT_EQ(words_of<Row>(kRows), (std::vector<std::string_view>{"pcd", "xyz"}));
}

TEST(FormatRows, ReadTheirFormatAndItsKinds) {
  EXPECT_EQ(row_of<Row>(kPcd, kRows), &kPcdRow);
  EXPECT_EQ(row_of<Row>(kComment, kRows), &kPcdRow);
  static constexpr Format other{.what = "other"};
  EXPECT_EQ(row_of<Row>(other, kRows), nullptr);
  EXPECT_EQ(formats_of<Row>(kRows), (std::vector<const Format*>{&kPcd, &kComment, &kXyz}));
}

TEST(FormatRows, AreGuessedOnlyWhereNoFormatIsSure) {
  EXPECT_EQ(row_recognised<Row>("# 1 2 3\n", kRows), &kPcdRow);
  EXPECT_EQ(row_recognised<Row>("1 2 3\n", kRows), &kXyzRow);
  EXPECT_EQ(row_recognised<Row>("2 3 4\n", kRows), nullptr);
}

TEST(Reads, KnowsTheToolsOfAFormat) {
  EXPECT_TRUE(reads("skyway-cloud", kPcd));
  EXPECT_FALSE(reads("skyway", kPcd));
  EXPECT_FALSE(reads("skyway-cloud", kXyz));
}

}  // namespace
}  // namespace geom
