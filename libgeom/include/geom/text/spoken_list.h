#pragma once

// Words in a row as a sentence has them.
//
// Example:
//   const std::string_view words[] = {"PCD", "PLY", "LAS"};
//   assert(geom::spoken_list(words, "or") == "PCD, PLY or LAS");

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace geom {

// "a", "a or b", "a, b or c": `last` stands before the last of several. Empty for no words.
inline std::string spoken_list(std::span<const std::string_view> words, std::string_view last) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0 && i + 1 < words.size()) out += ", ";
    if (i > 0 && i + 1 == words.size()) out += ' ' + std::string(last) + ' ';
    out += words[i];
  }
  return out;
}

}  // namespace geom
