#pragma once

// Words inside HTML and SVG.

#include <string>
#include <string_view>

namespace cli {

// As text between tags: neither "<" nor "&" means anything in it.
inline std::string escaped_markup(std::string_view words) {
  std::string out;
  for (const char c : words) {
    if (c == '<') {
      out += "&lt;";
    } else if (c == '&') {
      out += "&amp;";
    } else {
      out += c;
    }
  }
  return out;
}

}  // namespace cli
