#pragma once

// A text as one field of a CSV line.
//
// Example:
//   assert(geom::csv_field("tower, north") == "\"tower, north\"");
//   assert(geom::csv_field("tower") == "tower");

#include <string>
#include <string_view>

namespace geom {

// The text in quotes, with its own quotes doubled, if it has a comma, a quote, a line end, or a
// blank at either end; else the text as it is.
inline std::string csv_field(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t'; };
  const bool plain = text.find_first_of(",\"\r\n") == std::string_view::npos &&
                     (text.empty() || (!blank(text.front()) && !blank(text.back())));
  if (plain) return std::string(text);
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}

}  // namespace geom
