#pragma once

// What a reader of obstacles built of a text, and how much of it it skipped.

#include <cstddef>
#include <sstream>
#include <string>
#include <utility>

namespace support {

template <class Read>
std::pair<std::size_t, std::size_t> built_and_skipped(const Read& read, const std::string& text) {
  std::istringstream in(text);
  const auto out = read(in, "t");
  return {out.table.boxes.size(), out.skipped.count()};
}

}  // namespace support
