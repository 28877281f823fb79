#pragma once

// Numbers in text: read as std::from_chars reads them, written in the fewest digits.
//
// Example:
//   const std::string_view text = "12.5 m";
//   double metres = 0;
//   const auto read = geom::read_number(text.data(), text.data() + text.size(), metres);
//   assert(read.ec == std::errc() && metres == 12.5);
//   std::string out;
//   geom::append_number(out, 0.1);
//   assert(out == "0.1");
//
// What no double can hold is told apart.

#include <charconv>
#include <string>

namespace geom {

// As std::from_chars. A number too small for a double becomes the nearest, a zero with the number's
// sign, and is no error; one too large gives result_out_of_range and leaves `value` alone. No
// locale, no white space, no leading "+".
std::from_chars_result read_number(const char* first, const char* last, double& value);

// Appends the shortest text that reads back as the same number; `null` for one that is not finite.
void append_number(std::string& out, double value);

}  // namespace geom
