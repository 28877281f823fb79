// Pictures as files.

#include "geom/picture/image_file.h"

#include <gtest/gtest.h>

#include <cstring>

namespace {

TEST(Pfm, HoldsRowsFromTheBottom) {
  const geom::picture::Picture picture{3, 2, {}, {0, 1.25f, 2.5f, 655.349f, 655.36f, 3}, {}};
  const std::string bytes = geom::picture::pfm(picture);
  const std::string header = "Pf\n3 2\n-1.0\n";
  ASSERT_EQ(bytes.substr(0, header.size()), header);
  ASSERT_EQ(bytes.size(), header.size() + 24);
  float first = 0;
  std::memcpy(&first, bytes.data() + header.size(), 4);
  EXPECT_EQ(first, 655.349f);
}

TEST(Y4m, HasTheLimitedRangeOfBt601) {
  EXPECT_EQ(geom::picture::y4m_header(640, 480, 29.97002997002997).substr(0, 30),
            "YUV4MPEG2 W640 H480 F30000:100");
  EXPECT_NE(geom::picture::y4m_header(4, 4, 10).find(" F10:1 "), std::string::npos);
  geom::picture::Picture white{
      3, 3, std::vector<geom::picture::Colour>(9, {255, 255, 255}), {}, {}};
  const std::string frame = geom::picture::y4m_frame(white);
  ASSERT_EQ(frame.size(), 6u + 9 + 4 + 4);
  EXPECT_EQ(static_cast<unsigned char>(frame[6]), 235);
  EXPECT_EQ(static_cast<unsigned char>(frame[15]), 128);
  EXPECT_EQ(static_cast<unsigned char>(frame[22]), 128);
  geom::picture::Picture red{2, 2, std::vector<geom::picture::Colour>(4, {255, 0, 0}), {}, {}};
  const std::string reds = geom::picture::y4m_frame(red);
  EXPECT_EQ(static_cast<unsigned char>(reds[6]), 81);  // BT.601: 81, 90, 240
  EXPECT_EQ(static_cast<unsigned char>(reds[10]), 90);
  EXPECT_EQ(static_cast<unsigned char>(reds[11]), 240);
}

}  // namespace
