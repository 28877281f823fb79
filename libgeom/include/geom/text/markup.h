#pragma once

// Words inside HTML, SVG and KML.

#include <string>
#include <string_view>

namespace geom {

// As text between tags, where "<", ">" and "&" stand for themselves; control characters, which XML
// cannot hold, become spaces.
inline std::string escaped_markup(std::string_view words) {
  std::string out;
  for (const char c : words) {
    if (c == '<') {
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
