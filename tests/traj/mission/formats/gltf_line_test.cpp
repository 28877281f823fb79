#include "traj/mission/formats/gltf_line.h"

#include <gtest/gtest.h>

#include <sstream>

#include "geom/base/error.h"
#include "traj/mission/mavlink/examples.h"

namespace traj {
namespace {

using testing::kPoints;

TEST(GltfLine, ComesBackToSinglePrecisionAndRefusesOtherBytes) {
  std::stringstream file;
  write_gltf_line(file, kPoints, "line", "");
  const std::string bytes = file.str();
  const auto lines = read_gltf_lines(file, "f");
  ASSERT_EQ(lines.size(), 1u);
  const geom::Polyline& back = lines[0];
  ASSERT_EQ(back.size(), kPoints.size());
  EXPECT_EQ(back[0], kPoints[0]);
  for (std::size_t i = 0; i < kPoints.size(); ++i) EXPECT_LT((back[i] - kPoints[i]).norm(), 1e-4);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    std::istringstream part(bytes.substr(0, size));
    EXPECT_THROW(read_gltf_lines(part, "f"), geom::InputError) << size;
  }
}

}  // namespace
}  // namespace traj
