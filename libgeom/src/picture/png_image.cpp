#include "geom/picture/png_image.h"

#include <fmt/format.h>
#include <png.h>

#include <csetjmp>
#include <exception>
#include <functional>
#include <memory>
#include <new>
#include <stdexcept>

#include "geom/base/error.h"

namespace geom::picture {
namespace {

struct Layout {
  int bits;
  int kind;  // PNG_COLOR_TYPE_…
  int bytes_a_pixel;
};

struct Written {
  std::string bytes;
  std::exception_ptr failure;
};

// libpng is C, and nothing is thrown through it: what goes wrong is kept, and libpng told.
void append(png_structp png, png_bytep bytes, std::size_t count) noexcept {
  auto& out = *static_cast<Written*>(png_get_io_ptr(png));
  try {
    out.bytes.append(reinterpret_cast<const char*>(bytes), count);
    return;
  } catch (...) {
    out.failure = std::current_exception();
  }
  png_error(png, "out of memory");
}

void refuse(png_structp png, png_const_charp message) noexcept {
  auto& out = *static_cast<Written*>(png_get_error_ptr(png));
  if (!out.failure) {
    try {
      out.failure =
          std::make_exception_ptr(std::runtime_error(std::string("cannot write PNG: ") + message));
    } catch (...) {
      out.failure = std::current_exception();
    }
  }
  png_longjmp(png, 1);
}

struct Destroy {
  png_infop info = nullptr;
  void operator()(png_structp png) { png_destroy_write_struct(&png, &info); }
};

// `row(y)` gives the bytes of a row. False where libpng refused: it then leaves this by a jump, so
// that there must be nothing here to destroy.
bool write_all(png_structp png, png_infop info, const Picture& picture, const Layout& layout,
               const std::function<png_const_bytep(int)>& row) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_compression_level(png, 3);  // flat colours: more is slow and little smaller
  png_set_IHDR(png, info, static_cast<png_uint_32>(picture.width),
               static_cast<png_uint_32>(picture.height), layout.bits, layout.kind,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  for (int y = 0; y < picture.height; ++y) png_write_row(png, row(y));
  png_write_end(png, info);
  return true;
}

std::string encoded(const Picture& picture, const Layout& layout,
                    const std::function<png_const_bytep(int)>& row) {
  Written out;
  std::unique_ptr<png_struct, Destroy> png(
      png_create_write_struct(PNG_LIBPNG_VER_STRING, &out, refuse, nullptr));
  if (!png) throw std::bad_alloc();
  png_infop info = png_create_info_struct(png.get());
  if (!info) throw std::bad_alloc();
  png.get_deleter().info = info;
  png_set_write_fn(png.get(), &out, append, nullptr);
  const bool written = write_all(png.get(), info, picture, layout, row);
  if (out.failure) std::rethrow_exception(out.failure);
  if (!written) throw std::runtime_error("cannot write PNG");
  return std::move(out.bytes);
}

// Rows of what `put(pixel, bytes)` makes of each pixel.
template <class Put>
std::string encoded_pixels(const Picture& picture, const Layout& layout, const Put& put) {
  const auto width = static_cast<std::size_t>(picture.width);
  const auto step = static_cast<std::size_t>(layout.bytes_a_pixel);
  std::vector<png_byte> bytes(width * step);
  return encoded(picture, layout, [&](int y) {
    const std::size_t first = static_cast<std::size_t>(y) * width;
    for (std::size_t x = 0; x < width; ++x) put(first + x, bytes.data() + x * step);
    return bytes.data();
  });
}

struct Decoder {
  png_image image{};
  Decoder() { image.version = PNG_IMAGE_VERSION; }
  ~Decoder() { png_image_free(&image); }
  Decoder(const Decoder&) = delete;
  Decoder& operator=(const Decoder&) = delete;
};

}  // namespace

std::string colour_png(const Picture& picture) {
  return encoded(picture, {8, PNG_COLOR_TYPE_RGB, 3}, [&](int y) {
    const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width);
    return reinterpret_cast<png_const_bytep>(picture.colour.data() + at);
  });
}

std::string depth_png(const Picture& picture, double unit) {
  return encoded_pixels(picture, {16, PNG_COLOR_TYPE_GRAY, 2}, [&](std::size_t i, png_byte* to) {
    const double units = static_cast<double>(picture.depth[i]) / unit;
    const unsigned value = units < 65535.5 ? static_cast<unsigned>(units + 0.5) : 0;
    to[0] = static_cast<png_byte>(value >> 8);
    to[1] = static_cast<png_byte>(value);
  });
}

std::string id_png(const Picture& picture) {
  return encoded_pixels(picture, {8, PNG_COLOR_TYPE_RGB, 3}, [&](std::size_t i, png_byte* to) {
    for (int k = 0; k < 3; ++k) to[k] = static_cast<png_byte>(picture.id[i] >> (8 * k));
  });
}

Pixels read_png(std::string_view bytes, std::string_view name) {
  constexpr std::uint64_t kMostPixels = 1u << 26;
  Decoder decoder;
  png_image& image = decoder.image;
  if (!png_image_begin_read_from_memory(&image, bytes.data(), bytes.size())) {
    throw geom::InputError(
        std::string(name),
        {.expected = "a PNG picture", .found = fmt::format("none (libpng: {})", image.message)});
  }
  if (std::uint64_t{image.width} * image.height > kMostPixels) {
    throw geom::InputError(std::string(name),
                           {.expected = fmt::format("at most {} pixels", kMostPixels),
                            .found = fmt::format("{} x {}", image.width, image.height)});
  }
  image.format = PNG_FORMAT_RGB;
  Pixels out{static_cast<int>(image.width), static_cast<int>(image.height), {}};
  out.rgb.resize(PNG_IMAGE_SIZE(image));
  const png_color black{};
  if (!png_image_finish_read(&image, &black, out.rgb.data(), 0, nullptr)) {
    throw geom::InputError(
        std::string(name),
        {.expected = "a whole PNG picture",
         .found = fmt::format("a damaged or cut one (libpng: {})", image.message),
         .advice = "draw it again"});
  }
  return out;
}

}  // namespace geom::picture
