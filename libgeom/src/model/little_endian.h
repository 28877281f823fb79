#pragma once

// Numbers in others' bytes.

#include <bit>
#include <cstring>
#include <string_view>
#include <type_traits>

namespace geom {

// Precondition: they lie within the bytes.
template <class T>
T little_endian(std::string_view bytes, std::size_t at) {
  static_assert(std::is_arithmetic_v<T> && std::endian::native == std::endian::little);
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

}  // namespace geom
