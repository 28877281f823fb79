#include "webp_frame.h"

#include <fmt/format.h>
#include <webp/encode.h>

#include <cstdint>
#include <memory>
#include <stdexcept>

namespace view {
namespace {

constexpr float kQuality = 50;

}  // namespace

std::string webp(const geom::picture::Pixels& picture) {
  std::uint8_t* bytes = nullptr;
  const std::size_t size = WebPEncodeRGB(picture.rgb.data(), picture.width, picture.height,
                                         3 * picture.width, kQuality, &bytes);
  const std::unique_ptr<std::uint8_t, void (*)(void*)> owned(bytes, WebPFree);
  if (size == 0) {
    throw std::runtime_error(
        fmt::format("cannot write WebP of {} x {} pixels", picture.width, picture.height));
  }
  return {reinterpret_cast<const char*>(bytes), size};
}

}  // namespace view
