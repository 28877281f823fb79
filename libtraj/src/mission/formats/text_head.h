#pragma once

// How a text begins, for what recognises formats.

#include <algorithm>
#include <string_view>

namespace traj {

// The text without a byte order mark and white space before its first character.
inline std::string_view text_head(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  return text;
}

}  // namespace traj
