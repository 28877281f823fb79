#pragma once

// Arrays for the page: packed one after the other, and said in JSON where each is.

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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

  // The same in fewer bytes, for many whole numbers: columns of equal length one after the other,
  // of each value the difference from the one before (modulo 2^32, small ones of either sign
  // first), their lowest bytes before their higher ones, deflated. {"at":…,"bytes":…,"count":values
  // of a column,"columns":…,"type":"packed"}.
  Json add_packed(std::span<const std::vector<std::uint32_t>> columns);

  std::string base64() const;

 private:
  Json append(std::span<const std::byte> bytes, std::size_t size, const char* type);

  std::string bytes_;
};

// RFC 4648, section 4, with padding.
std::string base64(std::string_view bytes);

}  // namespace view
