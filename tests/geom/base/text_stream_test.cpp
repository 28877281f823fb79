#include "geom/base/text_stream.h"

#include <gtest/gtest.h>

#include <istream>
#include <new>
#include <ostream>
#include <streambuf>
#include <string>

namespace {

// What takes memory that is not there.
class NoMemory : public std::streambuf {
  int_type overflow(int_type) override { throw std::bad_alloc(); }
  int_type underflow() override { throw std::bad_alloc(); }
};

TEST(TextStream, ReadsItsText) {
  geom::TextInput in("first\nsecond");
  std::string line;
  ASSERT_TRUE(std::getline(in, line));
  EXPECT_EQ(line, "first");
  ASSERT_TRUE(std::getline(in, line));
  EXPECT_EQ(line, "second");
  EXPECT_FALSE(std::getline(in, line));
}

TEST(TextStream, ReadingThrowsIfMemoryRunsOut) {
  geom::TextInput in("");
  NoMemory none;
  in.std::istream::rdbuf(&none);
  std::string line;
  EXPECT_THROW(std::getline(in, line), std::bad_alloc);
}

TEST(TextStream, WritingThrowsIfMemoryRunsOut) {
  geom::TextOutput out;
  NoMemory none;
  out.std::ostream::rdbuf(&none);
  EXPECT_THROW(out << "text", std::bad_alloc);
}

}  // namespace
