#pragma once

// A line of short numbers between commas, read 64 characters at a time.

#include <emmintrin.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "short_number.h"

namespace geom {

// Bit i is set where character i of 64 is no digit.
inline std::uint64_t non_digits(const char* text) {
  const __m128i nine = _mm_set1_epi8(9);
  std::uint64_t out = 0;
  for (int part = 0; part < 4; ++part) {
    const auto* const at = reinterpret_cast<const __m128i*>(text + 16 * part);
    const __m128i value = _mm_sub_epi8(_mm_loadu_si128(at), _mm_set1_epi8('0'));
    const __m128i is_digit = _mm_cmpeq_epi8(_mm_min_epu8(value, nine), value);
    const auto digits = static_cast<std::uint16_t>(_mm_movemask_epi8(is_digit));
    out |= static_cast<std::uint64_t>(static_cast<std::uint16_t>(~digits)) << (16 * part);
  }
  return out;
}

// The number of `count` digits, 1 to 8, before `end`; the eight bytes before `end` are read. Pairs
// of digits, then of these, then of those are added in one word (Lemire, "Quickly parsing eight
// digits", 2018).
inline std::uint64_t digits_before(const char* end, std::size_t count) {
  std::uint64_t word;
  std::memcpy(&word, end - 8, 8);
  const std::size_t others = 8 * (8 - count);
  word = (word ^ 0x3030303030303030) >> others << others;
  word = 10 * word + (word >> 8);
  constexpr std::uint64_t kPairs = 0x000000ff000000ff;
  const std::uint64_t high = (word & kPairs) * 0x000f424000000064;
  const std::uint64_t low = (word >> 16 & kPairs) * 0x0000271000000001;
  return (high + low) >> 32;
}

// Reads N numbers as read_short() does, with commas between them and a line feed behind them, from
// `at` on, a place in `text`. Returns where the next line begins. Null where the line may be
// anything else: it has blanks, is longer than 65 characters, has numbers of more than 8 digits
// before the point or 7 behind it, or stands near the beginning or end of the text.
template <std::size_t N>
const char* read_short_row(const char* at, std::string_view text, std::array<double, N>& numbers) {
  static constexpr std::uint64_t kTens[] = {1, 10, 100, 1000, 10000, 100000, 1000000, 10000000};
  if (at - text.data() < 8 || text.data() + text.size() - at <= 64) return nullptr;
  std::uint64_t marks = non_digits(at);
  const auto next_mark = [&] {  // at + 64 where there is none, which no number reaches
    const char* const mark = at + std::countr_zero(marks);
    marks &= marks - 1;
    return mark;
  };
  const char* field = at;
  for (std::size_t i = 0; i < N; ++i) {
    const bool negative = *field == '-';
    if (negative) field = next_mark() + 1;
    const char* end = next_mark();
    const auto before = static_cast<std::size_t>(end - field);
    if (before - 1 >= 8) return nullptr;  // none, or too many
    std::uint64_t whole = digits_before(end, before);
    std::size_t behind = 0;
    if (*end == '.') {
      const char* const point = end;
      end = next_mark();
      behind = static_cast<std::size_t>(end - point) - 1;
      if (behind - 1 >= 7) return nullptr;
      whole = whole * kTens[behind] + digits_before(end, behind);
    }
    if (end - at >= 64) return nullptr;
    const bool last = i + 1 == N;
    if (last && *end == '\r') ++end;  // 65 characters are there
    if (*end != (last ? '\n' : ',')) return nullptr;
    const double size = static_cast<double>(whole) / static_cast<double>(kTens[behind]);
    numbers[i] = negative ? -size : size;
    field = end + 1;
  }
  return field;
}

}  // namespace geom
