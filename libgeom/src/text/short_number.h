#pragma once

// The short numbers that nearly all texts have, read in place.

#include <cstddef>
#include <cstdint>

namespace geom {

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }

// Digits with at most one point, 15 of them at most and no exponent: then the digits and the power
// of ten are both doubles, and the division rounds once, which is the nearest double (Clinger,
// "How to read floating point numbers accurately", 1990). Null for every other text.
inline const char* read_short(const char* first, const char* last, double& value) {
  static constexpr double kPowers[] = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                       1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
  const bool negative = first != last && *first == '-';
  const char* at = first + negative;
  std::uint64_t whole = 0;
  const auto take_digits = [&] {
    const char* const begin = at;
    for (; at != last && is_digit(*at); ++at) {
      whole = whole * 10 + static_cast<std::uint64_t>(*at - '0');
    }
    return at - begin;
  };
  const std::ptrdiff_t before = take_digits();
  std::ptrdiff_t behind = 0;
  if (at != last && *at == '.') {
    ++at;
    behind = take_digits();
    if (behind == 0) return nullptr;
  }
  if (before == 0 || before + behind > 15) return nullptr;
  if (at != last && (*at == 'e' || *at == 'E')) return nullptr;
  const double size = static_cast<double>(whole) / kPowers[behind];
  value = negative ? -size : size;
  return at;
}

}  // namespace geom
