#include "geom/base/hashed_stream.h"

#include <gtest/gtest.h>

#include <span>
#include <sstream>

#include "geom/base/sha256.h"

namespace {

std::string sum_of(const std::string& text) {
  geom::Sha256 sum;
  sum.update(std::as_bytes(std::span(text)));
  return "sha256:" + sum.hex();
}

TEST(HashedStream, ShowsTheHeadAndStillGivesAllOfIt) {
  std::istringstream in("first\nsecond\n");
  geom::HashedStream hashed(in);
  EXPECT_EQ(hashed.head(), "first\nsecond\n");
  std::string line;
  std::getline(hashed.stream(), line);
  EXPECT_EQ(line, "first");
}

TEST(HashedStream, SumsWhatWasLeftUnreadToo) {
  const std::string text(200'000, 'x');  // more than is held at once
  std::istringstream in(text + "end");
  geom::HashedStream hashed(in);
  EXPECT_EQ(hashed.head().size(), std::size_t{1} << 16);
  EXPECT_EQ(hashed.stream().get(), 'x');
  EXPECT_EQ(hashed.hash(), sum_of(text + "end"));
}

TEST(HashedStream, HasNoHeadWithoutInput) {
  std::istringstream in;
  geom::HashedStream hashed(in);
  EXPECT_TRUE(hashed.head().empty());
  EXPECT_EQ(hashed.hash(), sum_of(""));
}

}  // namespace
