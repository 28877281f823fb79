#pragma once

// Counts in sentences.
//
// Example:
//   assert(geom::counted(1, "box", "boxes") == "1 box");
//   assert(geom::counted(3, "point") == "3 points");

#include <cstddef>
#include <string>
#include <string_view>

namespace geom {

// "1 box", "3 boxes": counted(n, "box", "boxes").
inline std::string counted(std::size_t n, std::string_view one, std::string_view many) {
  return std::to_string(n) + ' ' + std::string(n == 1 ? one : many);
}

// "1 point", "3 points", of words that take an s.
inline std::string counted(std::size_t n, std::string_view one) {
  return counted(n, one, std::string(one) + 's');
}

}  // namespace geom
