#pragma once

// Arrays for the page: packed one after the other, and said in JSON where each is.

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

namespace view {

using Json = nlohmann::ordered_json;

class Bundle {
 public:
  // Appends the values, little endian, from a multiple of 4 bytes on. Returns
  // {"at":byte offset,"count":values,"type":NumPy's word for it}.
  Json add(std::span<const float> values) { return append(std::as_bytes(values), 4, "f4"); }
  Json add(std::span<const std::uint32_t> values) { return append(std::as_bytes(values), 4, "u4"); }
  Json add(std::span<const std::uint16_t> values) { return append(std::as_bytes(values), 2, "u2"); }
  Json add(std::span<const std::uint8_t> values) { return append(std::as_bytes(values), 1, "u1"); }

  std::string base64() const;

 private:
  Json append(std::span<const std::byte> bytes, std::size_t size, const char* type);

  std::string bytes_;
};

// RFC 4648, section 4, with padding.
std::string base64(std::string_view bytes);

}  // namespace view
