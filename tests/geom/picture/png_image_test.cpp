// Pictures as PNG.

#include "geom/picture/png_image.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cstring>

#include "geom/base/error.h"

namespace {

geom::picture::Picture small_picture() {
  geom::picture::Picture picture{3, 2, {}, {}, {}};
  picture.colour = {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {255, 255, 255}, {0, 0, 0}, {9, 8, 7}};
  picture.depth = {0, 1.25f, 2.5f, 655.349f, 655.36f, 3};
  picture.id = {0, 1, 256, 65536, 0xffffff, 70000};
  return picture;
}

// Read by libpng's simplified interface.
std::vector<std::uint8_t> decoded(const std::string& bytes) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_TRUE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()));
  image.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> out(PNG_IMAGE_SIZE(image));
  EXPECT_TRUE(png_image_finish_read(&image, nullptr, out.data(), 0, nullptr));
  return out;
}

TEST(Png, ColoursAndIdsComeBack) {
  const geom::picture::Picture picture = small_picture();
  const auto colour = decoded(geom::picture::colour_png(picture));
  const auto id = decoded(geom::picture::id_png(picture));
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ((geom::picture::Colour{colour[3 * i], colour[3 * i + 1], colour[3 * i + 2]}),
              picture.colour[i]);
    EXPECT_EQ(id[3 * i] + 256u * id[3 * i + 1] + 65536u * id[3 * i + 2], picture.id[i]);
  }
}

TEST(Png, DepthIsInUnitsAndZeroBeyondTheLast) {
  const std::string bytes = geom::picture::depth_png(small_picture(), 0.01);
  const auto* data = reinterpret_cast<png_const_bytep>(bytes.data());
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  struct Source {
    png_const_bytep at;
  } source{data};
  png_set_read_fn(png, &source, [](png_structp p, png_bytep to, std::size_t n) {
    auto* from = static_cast<Source*>(png_get_io_ptr(p));
    std::memcpy(to, from->at, n);
    from->at += n;
  });
  png_read_png(png, info, PNG_TRANSFORM_IDENTITY, nullptr);
  EXPECT_EQ(png_get_bit_depth(png, info), 16);
  EXPECT_EQ(png_get_color_type(png, info), PNG_COLOR_TYPE_GRAY);
  std::vector<unsigned> values;
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 3; ++x) {
      const png_bytep p = png_get_rows(png, info)[y] + 2 * x;
      values.push_back(256u * p[0] + p[1]);
    }
  }
  png_destroy_read_struct(&png, &info, nullptr);
  EXPECT_EQ(values, (std::vector<unsigned>{0, 125, 250, 65535, 0, 300}));
}

TEST(ReadPng, TakesWholePicturesOnly) {
  geom::picture::Picture picture{5, 3, std::vector<geom::picture::Colour>(15, {9, 8, 7}), {}, {}};
  for (std::size_t i = 0; i < 15; ++i) picture.colour[i].r = static_cast<std::uint8_t>(17 * i);
  const std::string png = geom::picture::colour_png(picture);
  const geom::picture::Pixels read = geom::picture::read_png(png, "f.png");
  EXPECT_EQ(read.width, 5);
  EXPECT_EQ(read.height, 3);
  ASSERT_EQ(read.rgb.size(), 45u);
  EXPECT_EQ(std::memcmp(read.rgb.data(), picture.colour.data(), 45), 0);
  for (std::size_t bytes = 0; bytes + 16 < png.size(); ++bytes) {  // all but the checksum and IEND
    EXPECT_THROW(geom::picture::read_png(png.substr(0, bytes), "f.png"), geom::InputError) << bytes;
  }
}

}  // namespace
