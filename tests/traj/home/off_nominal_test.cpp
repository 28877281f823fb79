#include "traj/home/off_nominal.h"

#include <gtest/gtest.h>

#include "geom/map/geodetic_outline.h"
#include "geom/text/instant.h"
#include "traj/scenes.h"

namespace traj {
namespace {

const geom::CollisionScene& scene() {
  static const geom::CollisionScene made =
      testing::scene_of({}, {{-900, -900, 0}, {900, 900, 200}});
  return made;
}

Trajectory random_flight(unsigned seed) {
  Trajectory trajectory = testing::random_trajectory(seed, 4);
  for (Segment& segment : trajectory.segments) {
    for (Vec3& p : segment.point) p.z() += 60;
  }
  return trajectory;
}

ReturnsOnEarth earth(geom::Axes axes = geom::Axes::enu) {
  return {"2026-05-04T06:30:00Z", 12.25, {47, 8, 400}, {1, 2, 3}, axes};
}

TEST(OffNominalVolumes, HoldAllReturnsOfRandomFlights) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const FlightReturn of = flight_return(scene(), random_flight(seed), {}, 70);
    const ReturnsOnEarth over = earth(seed % 2 == 0 ? geom::Axes::neu : geom::Axes::enu);
    for (const std::size_t most : {1u, 3u, 8u}) {
      const auto volumes = off_nominal_volumes(of, over, most, "f");
      EXPECT_GE(volumes.size(), 1u);
      EXPECT_LE(volumes.size(), most);
      EXPECT_FALSE(why_returns_not_held(of, over, volumes, "f")) << seed;
    }
  }
}

// Places of returns, worked out from the sweeps' corners, are in the volume's polygon, heights and
// time.
TEST(OffNominalVolumes, HoldCornersOfReturns) {
  const FlightReturn of = flight_return(scene(), random_flight(3), {}, 70);
  const auto volumes = off_nominal_volumes(of, earth(), 1, "f");
  ASSERT_EQ(volumes.size(), 1u);
  const geom::MapOutline outline = geom::outline_on_map(volumes[0].outline, {47, 8, 400},
                                                        geom::CircleSide::within, "a volume", "f");
  EXPECT_TRUE(geom::is_not_after(*volumes[0].start, "2026-05-04T06:30:00Z", 12.25));
  for (std::size_t i = 0; i < of.stages.size(); ++i) {
    for (const FlightStage& stage : of.stages[i]) {
      for (const ReturnSweep& one : return_sweeps(of.task.models[i], stage, {of.task.home, 0})) {
        EXPECT_GE(one.region.low - 3, *volumes[0].lower - 400);
        EXPECT_LE(one.region.high + 3, *volumes[0].upper - 400);
        for (const Vec2& p : one.region.plan) {
          EXPECT_TRUE(geom::contains({outline.ring, {}}, p + Vec2(1, 2)));
          EXPECT_TRUE(geom::contains({outline.ring, {}}, p - Vec2(1, 2)));
        }
      }
    }
  }
}

TEST(WhyReturnsNotHeld, SaysSoOfVolumesThatAreTooSmall) {
  const FlightReturn of = flight_return(scene(), random_flight(5), {}, 70);
  const auto volumes = off_nominal_volumes(of, earth(), 2, "f");
  const auto with = [&](const auto& change) {
    auto changed = volumes;
    for (geom::Volume4d& volume : changed) change(volume);
    return why_returns_not_held(of, earth(), changed, "f").has_value();
  };
  EXPECT_FALSE(with([](geom::Volume4d&) {}));
  EXPECT_TRUE(with([](geom::Volume4d& v) { *v.upper -= 1; }));
  EXPECT_TRUE(with([](geom::Volume4d& v) { *v.lower += 1; }));
  EXPECT_TRUE(with([](geom::Volume4d& v) { v.start = "2026-05-04T06:30:13Z"; }));
  EXPECT_TRUE(with([](geom::Volume4d& v) { v.end = "2026-05-04T06:30:14Z"; }));
  EXPECT_TRUE(with([](geom::Volume4d& v) { v.end.reset(); }));
  EXPECT_TRUE(with([](geom::Volume4d& v) {
    for (geom::GeodeticPlace& p : v.outline.ring) p.latitude += 0.00005;
  }));
  EXPECT_TRUE(why_returns_not_held(of, earth(), {}, "f"));
}

}  // namespace
}  // namespace traj
