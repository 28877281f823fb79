#include "traj/figure/clearance.h"

#include <gtest/gtest.h>

#include "support/random_city.h"

namespace {

bool holds(const std::string& svg, const std::string& words) {
  return svg.find(words) != std::string::npos;
}

TEST(Clearance, IsThatOfTheScene) {
  geom::BoxMapSpec spec;
  spec.bounds = {{0, 0, 0}, {100, 100, 50}};
  const geom::BoxMap map(spec, support::table_of({{{40, 0, 0}, {50, 10, 20}}}));
  const geom::CollisionScene scene(map, {"box", {1, 1, 1}}, 0.5);
  const std::vector<geom::Vec3> path = {{20, 5, 5}, {30, 5, 5}, {20, 5, 5}};
  const traj::figure::ClearanceTrack track{"path q", traj::clearance_profile(scene, path, 100)};
  const std::string svg = traj::figure::clearance(scene, std::span(&track, 1), "length, m");
  EXPECT_TRUE(holds(svg, "least 9 m at"));  // 10 m less the vehicle, the margin not counted
  EXPECT_TRUE(holds(svg, "margin 0.5 m"));
  EXPECT_FALSE(holds(svg, "less than the margin"));
}

TEST(Clearance, SaysAndShadesWhatIsLessThanTheMargin) {
  geom::BoxMapSpec spec;
  spec.bounds = {{0, 0, 0}, {100, 100, 50}};
  const geom::BoxMap map(spec, support::table_of({{{40, 0, 0}, {50, 10, 20}}}));
  const geom::CollisionScene scene(map, {"box", {1, 1, 1}}, 0.5);
  const traj::figure::ClearanceTrack tracks[] = {
      {"path q", {{0, 2, 9}, {2, 5, 0.3}, {5, 6, 0.4995}}}};
  const std::string svg = traj::figure::clearance(scene, tracks, "length, m", " (1 path left out)");
  EXPECT_TRUE(holds(svg, "least 0.3 m at 2 m; less than the margin for 3 m"));
  EXPECT_TRUE(holds(svg, "fill-opacity"));
  EXPECT_TRUE(holds(svg, "(1 path left out)"));
}

}  // namespace
