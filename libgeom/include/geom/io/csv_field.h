#pragma once

// A text as one field of a CSV line.

#include <string>
#include <string_view>

namespace geom {

// In quotes, its own doubled, where it has a comma, a quote or a line's end; else as it is.
inline std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}

}  // namespace geom
