#pragma once

// Values as their bytes, for binary formats.
//
// Example:
//   std::string bytes;
//   geom::append_bytes(bytes, std::uint32_t{1});
//   assert(bytes == std::string("\1\0\0\0", 4));  // little endian

#include <bit>
#include <string>
#include <type_traits>

namespace geom {

// Appends the bytes of a number, little endian.
template <class T>
void append_bytes(std::string& bytes, const T& value) {
  static_assert(std::is_arithmetic_v<T> && std::endian::native == std::endian::little);
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace geom
