#pragma once

// Bytes that may be those of a big file, a stretch at a time.

#include <algorithm>
#include <cstddef>
#include <span>

#include "geom/base/mapped_file.h"

namespace geom {

// Calls f(bytes) for stretches of `bytes` in their order, so that a mapped file never takes much
// memory.
template <class F>
void for_each_stretch(std::span<const std::byte> bytes, const F& f) {
  constexpr std::size_t kStretch = std::size_t{1} << 24;
  for (std::size_t at = 0; at < bytes.size(); at += kStretch) {
    f(bytes.subspan(at, std::min(kStretch, bytes.size() - at)));
    trim_mapped_files();
  }
}

}  // namespace geom
