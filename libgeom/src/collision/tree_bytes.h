#pragma once

// What the trees of a scene may take.

#include <cstddef>

namespace geom {

inline constexpr std::size_t kMostBytesPerBox = 256;
inline constexpr std::size_t kMostBytesPerGroup = 1024;

// Bytes, of all groups of a map together; surely no less.
constexpr std::size_t most_tree_bytes(std::size_t boxes, std::size_t groups) {
  return boxes * kMostBytesPerBox + groups * kMostBytesPerGroup;
}

}  // namespace geom
