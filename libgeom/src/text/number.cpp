#include "geom/text/number.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <system_error>

namespace geom {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// The exponent behind "e", which may itself be beyond every integer: held within ±1e15, far more
// than a text has digits.
long long exponent_of(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  long long value = 0;
  for (const char c : text) value = std::min(value * 10 + (c - '0'), 1'000'000'000'000'000LL);
  return negative ? -value : value;
}

// Whether a decimal number, not 0, is less than 1 in magnitude.
bool is_small(std::string_view text) {
  const std::size_t e = std::min(text.find_first_of("eE"), text.size());
  const std::string_view mantissa = text.substr(0, e);
  const std::size_t point = std::min(mantissa.find('.'), mantissa.size());
  const std::size_t lead = mantissa.find_first_of("123456789");
  // The power of ten above the leading digit.
  const long long above = lead < point ? static_cast<long long>(point - lead)
                                       : -static_cast<long long>(lead - point - 1);
  return above + (e < text.size() ? exponent_of(text.substr(e + 1)) : 0) <= 0;
}

// Digits with at most one point, 15 of them at most and no exponent: then the digits and the power
// of ten are both doubles, and the division rounds once, which is the nearest double (Clinger,
// "How to read floating point numbers accurately", 1990). Null for every other text.
const char* read_short(const char* first, const char* last, double& value) {
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

}  // namespace

std::from_chars_result read_number(const char* first, const char* last, double& value) {
  if (const char* const end = read_short(first, last, value)) return {end, std::errc()};
  const std::from_chars_result read = std::from_chars(first, last, value);
  if (read.ec != std::errc::result_out_of_range) return read;
  const bool negative = *first == '-';
  const std::string_view text(first + negative,
                              static_cast<std::size_t>(read.ptr - first) - negative);
  const bool decimal = std::all_of(text.begin(), text.end(), [](char c) {
    return is_digit(c) || c == '.' || c == 'e' || c == 'E' || c == '+' || c == '-';
  });
  if (!decimal || !is_small(text)) return read;
  value = negative ? -0.0 : 0.0;
  return {read.ptr, std::errc()};
}

void append_number(std::string& out, double value) {
  if (!std::isfinite(value)) {
    out += "null";
    return;
  }
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  out.append(digits, end);
}

}  // namespace geom
