#pragma once

// Views of buffers, as glTF and subtrees of 3D Tiles have them.

#include <fmt/format.h>

#include <string_view>

#include "json_members.h"

namespace geom {

// The bytes of a buffer that a view of it ("byteOffset", "byteLength") is of. Refuses (InputError)
// what is not within it.
inline std::string_view bytes_of(const JsonMembers& view, std::string_view buffer) {
  const std::uint64_t offset = view.whole("byteOffset", 0);
  const std::uint64_t length = view.whole("byteLength");
  if (offset > buffer.size() || length > buffer.size() - offset) {
    view.refuse({.expected = fmt::format("it within the {} bytes of its buffer", buffer.size()),
                 .found = fmt::format("{} from {} on", length, offset)});
  }
  return buffer.substr(offset, length);
}

}  // namespace geom
