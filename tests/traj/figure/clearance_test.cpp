#include "traj/figure/clearance.h"

#include <gtest/gtest.h>

#include "support/reading.h"
#include "support/small_map.h"

namespace {

geom::CollisionScene block() {
  return {support::map_of({{0, 0, 0}, {100, 100, 50}}, {{{40, 0, 0}, {50, 10, 20}}}),
          {"box", {1, 1, 1}},
          0.5};
}

TEST(Clearance, IsThatOfTheScene) {
  const auto scene = block();
  const std::vector<geom::Vec3> path = {{20, 5, 5}, {30, 5, 5}, {20, 5, 5}};
  const traj::figure::ClearanceTrack track{"path q", traj::clearance_profile(scene, path, 100)};
  const std::string svg = traj::figure::clearance(scene, std::span(&track, 1), "length, m");
  EXPECT_TRUE(support::says(
      svg, "least 8.999 m at"));  // 10 m less the vehicle, without the margin, to 1 mm
  EXPECT_TRUE(support::says(svg, "margin 0.5 m"));
  EXPECT_FALSE(support::says(svg, "less than the margin"));
}

TEST(Clearance, SaysAndShadesWhatIsLessThanTheMargin) {
  const auto scene = block();
  const traj::figure::ClearanceTrack tracks[] = {
      {"path q", {{0, 2, 9}, {2, 5, 0.3}, {5, 6, 0.4995}}}};
  const std::string svg = traj::figure::clearance(scene, tracks, "length, m", " (1 path left out)");
  EXPECT_TRUE(support::says(svg, "least 0.3 m at 2 m; less than the margin for 3 m"));
  EXPECT_TRUE(support::says(svg, "fill-opacity"));
  EXPECT_TRUE(support::says(svg, "(1 path left out)"));
}

}  // namespace
