#include "bundle.h"

#include <bit>

#include "geom/archive/deflate.h"

namespace view {

Json Bundle::append(std::span<const std::byte> bytes, std::size_t size, const char* type) {
  static_assert(std::endian::native == std::endian::little);
  bytes_.resize((bytes_.size() + 3) / 4 * 4);
  const std::size_t at = bytes_.size();
  bytes_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return {{"at", at}, {"count", bytes.size() / size}, {"type", type}};
}

Json Bundle::add_packed(std::span<const std::vector<std::uint32_t>> columns) {
  const std::size_t count = columns.empty() ? 0 : columns.front().size();
  std::string planes(4 * count * columns.size(), '\0');
  std::size_t plane = 0;
  for (const std::vector<std::uint32_t>& column : columns) {
    std::uint32_t before = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t step = column[i] - before;
      const std::uint32_t folded = (step << 1) ^ (step >> 31 ? ~0u : 0u);
      for (std::size_t k = 0; k < 4; ++k) {
        planes[plane + k * count + i] = static_cast<char>(folded >> 8 * k & 255);
      }
      before = column[i];
    }
    plane += 4 * count;
  }
  const std::string small = geom::deflated(std::as_bytes(std::span(planes)));
  Json out = append(std::as_bytes(std::span(small)), 1, "packed");
  return {{"at", out["at"]},
          {"bytes", small.size()},
          {"count", count},
          {"columns", columns.size()},
          {"type", "packed"}};
}

std::string Bundle::base64() const { return view::base64(bytes_); }

std::string base64(std::string_view bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) {
      return i + k < bytes.size() ? static_cast<std::uint8_t>(bytes[i + k]) : 0u;
    };
    const std::uint32_t group = byte(0) << 16 | byte(1) << 8 | byte(2);
    text += kDigits[group >> 18];
    text += kDigits[group >> 12 & 63];
    text += i + 1 < bytes.size() ? kDigits[group >> 6 & 63] : '=';
    text += i + 2 < bytes.size() ? kDigits[group & 63] : '=';
  }
  return text;
}

}  // namespace view
