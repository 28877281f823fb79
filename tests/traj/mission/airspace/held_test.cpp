#include "traj/mission/airspace/held.h"

#include <gtest/gtest.h>

namespace traj {
namespace {

const geom::GeodeticOrigin kOrigin{48.2, 16.37, 200};

// 10 m/s east for 10 s at z = 50, from half a second after the epoch.
struct Flight {
  Trajectory trajectory;
  FlightOnEarth on_earth;

  Flight() {
    Segment s;
    s.duration = 10;
    for (std::size_t i = 0; i < kPoints; ++i) s.point[i] = {100.0 * i / kDegree, 0, 50};
    trajectory.segments.push_back(s);
    on_earth = {{&trajectory, 0.5, Vec3(1, 2, 0.5)}, "2026-05-04T06:30:00Z", kOrigin};
  }
};

geom::Volume4d box(double west, double east, double half, double low, double high) {
  geom::Volume4d out;
  const geom::GeographicFrame earth(kOrigin);
  const double corners[][2] = {{west, -half}, {east, -half}, {east, half}, {west, half}};
  for (const auto& [x, y] : corners) {
    geom::GeodeticPlace place;
    earth.to_geodetic(x, y, place.latitude, place.longitude);
    out.outline.ring.push_back(place);
  }
  out.lower = low + 200;
  out.upper = high + 200;
  out.start = "2026-05-04T06:30:00.5Z";
  out.end = "2026-05-04T06:30:10.5Z";
  return out;
}

std::optional<std::string> why_not(const std::vector<geom::Volume4d>& volumes) {
  return why_not_held(Flight().on_earth, volumes, "v");
}

TEST(Held, IsWhatHasTheWholeVehicleInside) {
  EXPECT_EQ(why_not({box(-1.01, 101.01, 2.01, 49.49, 50.51)}), std::nullopt);
  // The other direction of turn.
  geom::Volume4d turned = box(-1.01, 101.01, 2.01, 49.49, 50.51);
  std::reverse(turned.outline.ring.begin(), turned.outline.ring.end());
  EXPECT_EQ(why_not({turned}), std::nullopt);
}

TEST(Held, IsNotWhatSticksOut) {
  for (const auto& volume :
       {box(-0.99, 101.01, 2.01, 49.49, 50.51), box(-1.01, 100.99, 2.01, 49.49, 50.51),
        box(-1.01, 101.01, 1.99, 49.49, 50.51), box(-1.01, 101.01, 2.01, 49.51, 50.51),
        box(-1.01, 101.01, 2.01, 49.49, 50.49), box(-1.01, 101.01, 2.0000001, 49.49, 50.51)}) {
    EXPECT_EQ(why_not({volume}),
              "volume 0 does not hold the vehicle at all times from 2026-05-04T06:30:00.5Z to "
              "2026-05-04T06:30:10.5Z");
  }
}

TEST(Held, IsNotWhatHasAGapInTime) {
  geom::Volume4d first = box(-1.01, 61.01, 2.01, 49, 51);
  geom::Volume4d second = box(48.98, 101.01, 2.01, 49, 51);
  first.end = second.start = "2026-05-04T06:30:05.5Z";
  EXPECT_EQ(why_not({first, second}), std::nullopt);
  first.end = "2026-05-04T06:30:06.5Z";  // while the second holds it already
  EXPECT_EQ(why_not({first, second}), std::nullopt);
  first.end = "2026-05-04T06:30:05.499999999Z";
  EXPECT_EQ(why_not({first, second}),
            "no volume holds from 2026-05-04T06:30:05.499999999Z to 2026-05-04T06:30:05.5Z");
  first.end = second.start = "2026-05-04T06:30:05.4Z";  // 49 m, less its size
  EXPECT_EQ(why_not({first, second})->substr(0, 8), "volume 1");
  first.start = "2026-05-04T06:30:00.500000001Z";
  EXPECT_EQ(why_not({first, second}),
            "the first volume begins after the departure, at 2026-05-04T06:30:00.500000001Z");
  geom::Volume4d whole = box(-1.01, 101.01, 2.01, 49, 51);
  whole.end = "2026-05-04T06:30:10.499Z";
  EXPECT_EQ(why_not({whole}),
            "the last volume ends before the arrival, at 2026-05-04T06:30:10.499Z");
}

TEST(Held, IsNotWhatIsOpenOrNone) {
  EXPECT_EQ(why_not({}), "there is no volume");
  for (int i = 0; i < 4; ++i) {
    geom::Volume4d volume = box(-5, 105, 5, 40, 60);
    if (i == 0) volume.lower.reset();
    if (i == 1) volume.upper.reset();
    if (i == 2) volume.start.reset();
    if (i == 3) volume.end.reset();
    EXPECT_EQ(why_not({volume}), "a volume has no lower or upper altitude, no begin or no end");
  }
}

// A notch of the outline reaches in between points that are all inside.
TEST(Held, LooksAtEveryEdge) {
  geom::Volume4d notched = box(-5, 105, 5, 40, 60);
  geom::GeodeticPlace tip;
  geom::GeographicFrame(kOrigin).to_geodetic(50, 0, tip.latitude, tip.longitude);
  notched.outline.ring.insert(notched.outline.ring.begin() + 1, tip);
  EXPECT_EQ(why_not({notched})->substr(0, 8), "volume 0");
}

TEST(Held, TakesSegmentsThatMissEachOther) {
  Flight flight;
  flight.trajectory.segments.push_back(flight.trajectory.segments[0]);
  for (Vec3& p : flight.trajectory.segments[1].point) p = {100, 0, 50.005};
  geom::Volume4d volume = box(-1.1, 101.1, 2.1, 49, 50.5051);
  volume.end = "2026-05-04T06:30:20.5Z";
  EXPECT_TRUE(why_not_held(flight.on_earth, std::vector{volume}, "v"));
  volume.upper = 250.52;
  EXPECT_FALSE(why_not_held(flight.on_earth, std::vector{volume}, "v"));
}

}  // namespace
}  // namespace traj
