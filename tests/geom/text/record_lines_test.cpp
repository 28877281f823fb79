#include "geom/text/record_lines.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "geom/base/error.h"
#include "support/reading.h"

namespace geom {
namespace {

// What is taken of the text with so many threads, and then the refusal. A line of '?' is no record,
// and a record "no" is not taken.
std::string taken(const std::string& text, unsigned threads) {
  std::istringstream in(text);
  std::string out;
  const auto parse = [](const std::string& line, std::size_t number) {
    if (line.starts_with('?')) throw InputError("f", number, {.says = "no record"});
    return line;
  };
  const auto take = [&](const std::string& record, std::size_t number) {
    if (record == "no") throw InputError("f", number, {.says = "not taken"});
    out += std::to_string(number) + record.substr(0, 3) + ' ';
  };
  return out += support::refusal_of([&] { for_each_parsed(in, "f", {threads, {}}, parse, take); });
}

TEST(RecordLines, AreThoseThatAreNotBlank) {
  std::istringstream in("a\n\n \t\r\nb\r\n" + std::string(1 << 17, 'c') + "\nd");
  RecordLines lines(in, "f");
  std::string all;
  while (const auto line = lines.next()) {
    all += std::to_string(line->number) + line->text.substr(0, 3) + ' ';
  }
  EXPECT_EQ(all, "1a 4b\r 5ccc 6d ");
  EXPECT_FALSE(lines.next());
}

TEST(RecordLines, RefuseAnEmptyStreamAndAnArchive) {
  for (const char* text : {"", "\n\n", "PK\x03\x04..."}) {
    std::istringstream in(text);
    RecordLines lines(in, "f");
    EXPECT_NE(support::refusal_of([&] { lines.next(); }), "") << text;
  }
}

TEST(ParsedLines, AreTakenInOrder) {
  std::string text;
  std::string expected;
  for (int i = 1; i <= 3000; ++i) {
    text += std::to_string(i) + '\n';
    expected += std::to_string(i) + std::to_string(i).substr(0, 3) + ' ';
  }
  for (const unsigned threads : {1u, 2u, 7u}) {
    EXPECT_EQ(taken("a\n\nb\r\n  \nc", threads), "1a 3b\r 5c ") << threads;
    EXPECT_EQ(taken(text, threads), expected) << threads;
  }
}

TEST(ParsedLines, MayBeMoreThanAreParsedAtOnce) {
  std::string text;
  std::string expected;
  const std::string tail(kLinesAtOnce / 3, 'x');
  for (int i = 1; i <= 10; ++i) {
    text += 'a' + tail + '\n';
    expected += std::to_string(i) + "axx ";
  }
  for (const unsigned threads : {1u, 2u, 7u}) {
    EXPECT_EQ(taken(text, threads), expected) << threads;
    EXPECT_EQ(taken(text + "?\n", threads), expected + "f:11: no record") << threads;
    EXPECT_EQ(taken(text + "no\n?\n", threads), expected + "f:11: not taken") << threads;
    EXPECT_EQ(taken("no\n" + text + "?\n", threads), "f:1: not taken") << threads;
  }
}

TEST(ParsedLines, RefuseTheFirstThatIsWrong) {
  for (const unsigned threads : {1u, 2u, 7u}) {
    EXPECT_EQ(taken("a\nb\n?\nc\nno\n?\n", threads), "1a 2b f:3: no record") << threads;
    EXPECT_EQ(taken("a\nno\n?\nc\n", threads), "1a f:2: not taken") << threads;
    EXPECT_EQ(taken("?\nno", threads), "f:1: no record") << threads;
    EXPECT_TRUE(support::says(taken("\n", threads), "found an empty stream")) << threads;
  }
}

}  // namespace
}  // namespace geom
