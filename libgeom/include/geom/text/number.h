#pragma once

// One rule for numbers in text: as std::from_chars reads them, and what no double can hold told
// apart; as std::to_chars writes them.

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
