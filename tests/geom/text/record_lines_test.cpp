#include "geom/text/record_lines.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "geom/base/error.h"
#include "support/reading.h"

namespace geom {
namespace {

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

}  // namespace
}  // namespace geom
