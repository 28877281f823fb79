#include "traj/mission/formats/fence_file.h"

#include <gtest/gtest.h>

#include "support/reading.h"

namespace traj {
namespace {

std::vector<GeodeticFence> read(const std::string& text) {
  return read_fences(support::Text(text), "f");
}

std::string refusal(const std::string& text) {
  return support::refusal_of([&] { read(text); });
}

TEST(ReadFences, NeedsNoMission) {
  const auto circle = read("QGC WPL 110\n0\t0\t3\t5004\t9\t0\t0\t0\t47\t8\t0\t1\n");
  ASSERT_EQ(circle.size(), 1u);
  EXPECT_EQ(circle[0].radius, 9);
  const auto polygon = read(R"( {"fileType":"Plan","version":1,"geoFence":{"version":2,"polygons":[
    {"inclusion":true,"polygon":[[47,8],[47.1,8],[47,8.1]]}]}})");
  ASSERT_EQ(polygon.size(), 1u);
  EXPECT_TRUE(polygon[0].inclusion);
}

TEST(ReadFences, RefusesFilesWithoutAFence) {
  EXPECT_EQ(refusal("QGC WPL 110\n"), "f: expected a fence, found none");
  EXPECT_EQ(refusal(R"({"fileType":"Plan","version":1})"), "f: expected a fence, found none");
  EXPECT_EQ(refusal(R"({"fileType":"Survey","version":1})"),
            "f: plan.fileType must be \"Plan\", found \"Survey\"");
  EXPECT_EQ(refusal(""), "f: expected a fence, found none");
}

}  // namespace
}  // namespace traj
