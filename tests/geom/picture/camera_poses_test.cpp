// Poses of cameras as a table.

#include "geom/picture/camera_poses.h"

#include <gtest/gtest.h>

#include <sstream>

#include "geom/base/error.h"
#include "support/random_city.h"

namespace {

using geom::picture::View;
using support::Random;

TEST(CameraPoses, ComeBackBitForBit) {
  Random random(7);
  std::string text = std::string(geom::picture::kPosesHeader) + "\n";
  std::vector<View> views(20);
  for (std::size_t i = 0; i < views.size(); ++i) {
    for (int k = 0; k < 3; ++k) views[i].eye[k] = random.uniform(-1e3, 1e3);
    text += geom::picture::pose_row(views[i], i, 0.1 * static_cast<double>(i));
  }
  std::istringstream in(text);
  const auto poses = geom::picture::read_camera_poses(in, "poses");
  ASSERT_EQ(poses.size(), views.size());
  for (std::size_t i = 0; i < views.size(); ++i) {
    EXPECT_EQ(poses[i].eye, views[i].eye) << "seed 7, row " << i;
    EXPECT_EQ(poses[i].time, 0.1 * static_cast<double>(i));
  }
}

TEST(CameraPoses, RefusesOtherTables) {
  const std::string header = std::string(geom::picture::kPosesHeader) + "\n";
  for (const std::string& rows :
       {std::string(), std::string("0,0,1,2,3,1,0,0\n"), std::string("0,0,1,2,nan,1,0,0,0\n"),
        std::string("1,0,1,2,3,1,0,0,0\n"), std::string("0,0,1,2,3,1,0,0,0\n1,0,1,2,3,1,0,0,0\n"),
        std::string("0,0,1,2,3,1,0,0,0\n0,1,1,2,3,1,0,0,0\n")}) {
    std::istringstream in(header + rows);
    EXPECT_THROW(geom::picture::read_camera_poses(in, "poses"), geom::InputError) << rows;
  }
  std::istringstream other("frame,t_s\n0,0\n");
  EXPECT_THROW(geom::picture::read_camera_poses(other, "poses"), geom::InputError);
}

}  // namespace
