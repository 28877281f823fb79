#include "geom/text/number.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <system_error>

#include "short_number.h"

namespace geom {
namespace {

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
