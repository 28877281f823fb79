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

}  // namespace
}  // namespace geom
