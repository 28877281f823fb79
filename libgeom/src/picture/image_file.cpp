#include "geom/picture/image_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace geom::picture {
namespace {

static_assert(std::endian::native == std::endian::little);

// A frame rate as a fraction: millionths where it is not whole.
std::pair<long long, long long> fraction(double rate) {
  for (const long long parts : {1LL, 1001LL, 1000000LL}) {
    const double scaled = rate * static_cast<double>(parts);
    if (scaled == std::round(scaled)) return {std::llround(scaled), parts};
  }
  return {std::max(1LL, std::llround(rate * 1e6)), 1000000};
}

// BT.601, limited range, in 1/65536: luma 16 to 235, chroma 16 to 240.
char luma(const Colour& c) {
  return static_cast<char>((16829 * c.r + 33039 * c.g + 6416 * c.b + (16 << 16) + 32768) >> 16);
}

struct Sum {
  int r = 0;
  int g = 0;
  int b = 0;
};

// Of the sum of four pixels.
char blue_difference(const Sum& s) {
  return static_cast<char>((-9714 * s.r - 19071 * s.g + 28784 * s.b + (512 << 16) + 131072) >> 18);
}
char red_difference(const Sum& s) {
  return static_cast<char>((28784 * s.r - 24103 * s.g - 4681 * s.b + (512 << 16) + 131072) >> 18);
}

}  // namespace

std::string pfm(const Picture& picture) {
  std::string out = fmt::format("Pf\n{} {}\n-1.0\n", picture.width, picture.height);
  const auto width = static_cast<std::size_t>(picture.width);
  for (int y = picture.height; y-- > 0;) {
    const float* row = picture.depth.data() + static_cast<std::size_t>(y) * width;
    out.append(reinterpret_cast<const char*>(row), width * sizeof(float));
  }
  return out;
}

std::string y4m_header(int width, int height, double rate) {
  const auto [frames, seconds] = fraction(rate);
  return fmt::format("YUV4MPEG2 W{} H{} F{}:{} Ip A1:1 C420jpeg XCOLORRANGE=LIMITED\n", width,
                     height, frames, seconds);
}

std::string y4m_frame(const Picture& picture) {
  const int width = picture.width;
  const int height = picture.height;
  const int half_width = (width + 1) / 2;
  const int half_height = (height + 1) / 2;
  const auto quarter = static_cast<std::size_t>(half_width) * static_cast<std::size_t>(half_height);
  std::string out = "FRAME\n";
  const std::size_t start = out.size();
  out.resize(start + picture.pixels() + 2 * quarter);
  char* y_plane = out.data() + start;
  for (const Colour& c : picture.colour) *y_plane++ = luma(c);
  char* blue = y_plane;
  char* red = blue + quarter;
  for (int y = 0; y < half_height; ++y) {
    const Colour* top = picture.colour.data() + static_cast<std::ptrdiff_t>(2 * y) * width;
    const Colour* bottom = 2 * y + 1 < height ? top + width : top;
    for (int x = 0; x < half_width; ++x) {
      const int left = 2 * x;
      const int right = std::min(left + 1, width - 1);
      Sum sum;
      for (const Colour* c : {top + left, top + right, bottom + left, bottom + right}) {
        sum.r += c->r;
        sum.g += c->g;
        sum.b += c->b;
      }
      *blue++ = blue_difference(sum);
      *red++ = red_difference(sum);
    }
  }
  return out;
}

}  // namespace geom::picture
