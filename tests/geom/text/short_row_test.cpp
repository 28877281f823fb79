#include "text/short_row.h"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <bit>
#include <random>
#include <string>

namespace geom {
namespace {

using Numbers = std::array<double, 6>;

// What six calls of read_short() make of the line that begins at `at`.
const char* read_one_by_one(const char* at, const std::string& text, Numbers& numbers) {
  const char* const end = text.data() + text.size();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    at = read_short(at, end, numbers[i]);
    if (!at) return nullptr;
    if (i == 5 && *at == '\r') ++at;
    if (at == end || *at++ != (i < 5 ? ',' : '\n')) return nullptr;
  }
  return at;
}

std::string number(std::mt19937_64& random) {
  const auto digits = [&](std::size_t most) {
    std::string out;
    for (std::size_t n = 1 + random() % most; n > 0; --n) {
      out += static_cast<char>('0' + random() % 10);
    }
    return out;
  };
  std::string out = random() % 3 ? "" : "-";
  out += digits(random() % 8 ? 6 : 9);
  if (random() % 4) out += "." + digits(random() % 8 ? 4 : 9);
  return out;
}

// Where it reads a line, the numbers and the end are those of read_short(), bit for bit; and it
// reads nearly every plain line.
TEST(ShortRow, IsReadAsNumberByNumber) {
  std::mt19937_64 random(5);
  constexpr std::string_view kOdd = "0123456789.,-+ e\r\n;x";
  std::size_t read = 0;
  for (int i = 0; i < 200000; ++i) {
    std::string text = "12345678\n";
    const std::size_t begin = random() % 4 ? 9 : random() % 10;
    for (int k = 0; k < 6; ++k) text += number(random) + (k < 5 ? "," : "");
    text += random() % 8 ? "\n" : "\r\n";
    text += std::string(random() % 100, '7');
    if (random() % 2) text[begin + random() % (text.size() - begin)] = kOdd[random() % kOdd.size()];
    Numbers numbers{};
    const char* const end = read_short_row(text.data() + begin, text, numbers);
    if (!end) continue;
    ++read;
    Numbers expected{};
    ASSERT_EQ(end, read_one_by_one(text.data() + begin, text, expected)) << text;
    for (std::size_t k = 0; k < 6; ++k) {
      ASSERT_EQ(std::bit_cast<std::uint64_t>(numbers[k]), std::bit_cast<std::uint64_t>(expected[k]))
          << text;
    }
  }
  EXPECT_GT(read, 20000u);
}

TEST(ShortRow, NeedsRoomBeforeAndBehind) {
  const std::string line = "1,2,3,4,5,6\n";
  const std::string text = "       \n" + line + std::string(53, ' ');
  Numbers numbers{};
  EXPECT_EQ(read_short_row(text.data() + 8, text, numbers), text.data() + 8 + line.size());
  EXPECT_EQ(read_short_row(text.data() + 7, text, numbers), nullptr);
  const std::string_view shorter(text.data(), text.size() - 1);
  EXPECT_EQ(read_short_row(text.data() + 8, shorter, numbers), nullptr);
}

// A text that ends where nothing may be read.
class TextBeforeNothing {
 public:
  explicit TextBeforeNothing(std::string_view text)
      : page_(static_cast<std::size_t>(sysconf(_SC_PAGESIZE))),
        pages_(static_cast<char*>(
            mmap(nullptr, 2 * page_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0))),
        size_(text.size()) {
    text.copy(pages_ + page_ - size_, size_);
    mprotect(pages_ + page_, page_, PROT_NONE);
  }
  ~TextBeforeNothing() { munmap(pages_, 2 * page_); }
  TextBeforeNothing(const TextBeforeNothing&) = delete;
  TextBeforeNothing& operator=(const TextBeforeNothing&) = delete;

  std::string_view text() const { return {pages_ + page_ - size_, size_}; }

 private:
  std::size_t page_;
  char* pages_;
  std::size_t size_;
};

TEST(ShortRow, ReadsNothingBehindTheText) {
  const std::string digits = "1234567.12345";
  int read = 0;
  for (const std::string_view tail : {"\r", "\r\n", "\n", ".", "-", ",", "5", ""}) {
    for (std::size_t size = 40; size < 70; ++size) {
      std::string line;
      for (int k = 0; k < 5; ++k) line += digits.substr(0, size / 6) + ",";
      line += "1." + std::string(size, '3');
      line = line.substr(0, size);
      const TextBeforeNothing held("12345678\n" + line + std::string(tail));
      Numbers numbers{};
      const char* const end = read_short_row(held.text().data() + 9, held.text(), numbers);
      if (end) EXPECT_EQ(end, held.text().data() + held.text().size());
      read += end != nullptr;
    }
  }
  EXPECT_EQ(read, 1);  // 63 characters and \r\n
}

}  // namespace
}  // namespace geom
