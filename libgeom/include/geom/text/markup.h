#pragma once

// Words inside HTML, SVG and KML.
//
// Example:
//   assert(geom::escaped_markup("Tom & <Ann>") == "Tom &amp; &lt;Ann&gt;");

#include <string>
#include <string_view>

namespace geom {

// The words as they stand between tags or in double quotes: "<", ">", "&" and quotes are escaped. A
// character that XML cannot hold becomes a space: control characters, U+FFFE and U+FFFF (UTF-8).
inline std::string escaped_markup(std::string_view words) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const char c = words[i];
    if (words.substr(i, 3) == "\xef\xbf\xbe" || words.substr(i, 3) == "\xef\xbf\xbf") {
      out += ' ';
      i += 2;
    } else if (c == '"') {
      out += "&quot;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '&') {
      out += "&amp;";
    } else {
      out += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
  }
  return out;
}

}  // namespace geom
