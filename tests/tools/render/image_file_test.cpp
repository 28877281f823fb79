// Pictures and poses as files.

#include "render/image/image_file.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cstring>
#include <sstream>

#include "cli/run.h"
#include "geom/base/error.h"
#include "render/camera/camera_poses.h"
#include "render/image/frame_output.h"
#include "render/image/png_image.h"
#include "support/random_city.h"

namespace {

using render::View;
using support::Random;

render::Picture small_picture() {
  render::Picture picture{3, 2, {}, {}, {}};
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
  const render::Picture picture = small_picture();
  const auto colour = decoded(render::colour_png(picture));
  const auto id = decoded(render::id_png(picture));
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ((render::Colour{colour[3 * i], colour[3 * i + 1], colour[3 * i + 2]}),
              picture.colour[i]);
    EXPECT_EQ(id[3 * i] + 256u * id[3 * i + 1] + 65536u * id[3 * i + 2], picture.id[i]);
  }
}

TEST(Png, DepthIsInUnitsAndZeroBeyondTheLast) {
  const std::string bytes = render::depth_png(small_picture(), 0.01);
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

TEST(Pfm, HoldsRowsFromTheBottom) {
  const std::string bytes = render::pfm(small_picture());
  const std::string header = "Pf\n3 2\n-1.0\n";
  ASSERT_EQ(bytes.substr(0, header.size()), header);
  ASSERT_EQ(bytes.size(), header.size() + 24);
  float first = 0;
  std::memcpy(&first, bytes.data() + header.size(), 4);
  EXPECT_EQ(first, 655.349f);
}

TEST(Y4m, HasTheLimitedRangeOfBt601) {
  EXPECT_EQ(render::y4m_header(640, 480, 29.97002997002997).substr(0, 30),
            "YUV4MPEG2 W640 H480 F30000:100");
  EXPECT_NE(render::y4m_header(4, 4, 10).find(" F10:1 "), std::string::npos);
  render::Picture white{3, 3, std::vector<render::Colour>(9, {255, 255, 255}), {}, {}};
  const std::string frame = render::y4m_frame(white);
  ASSERT_EQ(frame.size(), 6u + 9 + 4 + 4);
  EXPECT_EQ(static_cast<unsigned char>(frame[6]), 235);
  EXPECT_EQ(static_cast<unsigned char>(frame[15]), 128);
  EXPECT_EQ(static_cast<unsigned char>(frame[22]), 128);
  render::Picture red{2, 2, std::vector<render::Colour>(4, {255, 0, 0}), {}, {}};
  const std::string reds = render::y4m_frame(red);
  EXPECT_EQ(static_cast<unsigned char>(reds[6]), 81);  // BT.601: 81, 90, 240
  EXPECT_EQ(static_cast<unsigned char>(reds[10]), 90);
  EXPECT_EQ(static_cast<unsigned char>(reds[11]), 240);
}

TEST(CameraPoses, ComeBackBitForBit) {
  Random random(7);
  std::string text = std::string(render::kPosesHeader) + "\n";
  std::vector<View> views(20);
  for (std::size_t i = 0; i < views.size(); ++i) {
    for (int k = 0; k < 3; ++k) views[i].eye[k] = random.uniform(-1e3, 1e3);
    text += render::pose_row(views[i], i, 0.1 * static_cast<double>(i));
  }
  std::istringstream in(text);
  const auto poses = render::read_camera_poses(in, "poses");
  ASSERT_EQ(poses.size(), views.size());
  for (std::size_t i = 0; i < views.size(); ++i) {
    EXPECT_EQ(poses[i].eye, views[i].eye) << "seed 7, row " << i;
    EXPECT_EQ(poses[i].time, 0.1 * static_cast<double>(i));
  }
}

TEST(CameraPoses, AreReadWithTheNamesOfEarlierReleases) {
  std::istringstream in("frame,t_s,x_m,y_m,z_m,qw,qx,qy,qz\n0,0.5,1,2,3,1,0,0,0\n");
  EXPECT_EQ(render::read_camera_poses(in, "poses").at(0).eye, geom::Vec3(1, 2, 3));
}

TEST(CameraPoses, RefusesOtherTables) {
  const std::string header = std::string(render::kPosesHeader) + "\n";
  for (const std::string& rows :
       {std::string(), std::string("0,0,1,2,3,1,0,0\n"), std::string("0,0,1,2,nan,1,0,0,0\n"),
        std::string("1,0,1,2,3,1,0,0,0\n"), std::string("0,0,1,2,3,1,0,0,0\n1,0,1,2,3,1,0,0,0\n"),
        std::string("0,0,1,2,3,1,0,0,0\n0,1,1,2,3,1,0,0,0\n")}) {
    std::istringstream in(header + rows);
    EXPECT_THROW(render::read_camera_poses(in, "poses"), geom::InputError) << rows;
  }
  std::istringstream other("frame,t_s\n0,0\n");
  EXPECT_THROW(render::read_camera_poses(other, "poses"), geom::InputError);
}

TEST(ReadPng, TakesWholePicturesOnly) {
  render::Picture picture{5, 3, std::vector<render::Colour>(15, {9, 8, 7}), {}, {}};
  for (std::size_t i = 0; i < 15; ++i) picture.colour[i].r = static_cast<std::uint8_t>(17 * i);
  const std::string png = render::colour_png(picture);
  const render::Pixels read = render::read_png(png, "f.png");
  EXPECT_EQ(read.width, 5);
  EXPECT_EQ(read.height, 3);
  ASSERT_EQ(read.rgb.size(), 45u);
  EXPECT_EQ(std::memcmp(read.rgb.data(), picture.colour.data(), 45), 0);
  for (std::size_t bytes = 0; bytes + 16 < png.size(); ++bytes) {  // all but the checksum and IEND
    EXPECT_THROW(render::read_png(png.substr(0, bytes), "f.png"), geom::InputError) << bytes;
  }
}

TEST(FrameOutput, NumbersNames) {
  EXPECT_EQ(render::numbered("a-%05d.png", 12), "a-00012.png");
  EXPECT_EQ(render::numbered("a%d", 7), "a7");
  EXPECT_EQ(render::numbered("%s.png", 7), "%s.png");
  EXPECT_THROW(render::FrameOutput("%n.png", 2, false), cli::UsageError);
  EXPECT_NO_THROW(render::FrameOutput("one.png", 1, false));
}

}  // namespace
