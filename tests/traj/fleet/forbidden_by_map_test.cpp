#include "traj/fleet/forbidden_by_map.h"

#include <gtest/gtest.h>

#include "support/random_city.h"
#include "traj/fleet/departures.h"
#include "traj/fleet/random_flights.h"
#include "traj/proof/check.h"
#include "traj/scenes.h"

namespace traj {
namespace {

using geom::CollisionScene;
using geom::TimeSpan;
using testing::holds;
using testing::rest;
using testing::steady;

constexpr double kForever = std::numeric_limits<double>::infinity();

CollisionScene scene_of(const std::vector<geom::Aabb>& boxes, const std::vector<TimeSpan>& times) {
  geom::BoxTable table = support::table_of(boxes);
  for (std::size_t i = 0; i < times.size(); ++i) table.set_time(i, times[i]);
  const geom::Aabb bounds{Vec3::Constant(-200), Vec3::Constant(200)};
  return {
      {{.bounds = bounds, .epoch = "2026-05-04T06:30:00Z"}, table}, {"box", {0.5, 0.5, 0.5}}, 0};
}

TEST(ForbiddenByMap, IsTheTimeOfTheBoxLessThatOfTheFlightInIt) {
  // The grown box is at -5.5 to 5.5: from 9.45 to 10.55 s after the departure.
  const auto spans = forbidden_by_map(scene_of({{{-5, -5, -5}, {5, 5, 5}}}, {{1000, 1060}}),
                                      steady(), Parked::gone);
  ASSERT_EQ(spans.size(), 1u);
  EXPECT_LE(spans[0].low, 1000 - 10.55);
  EXPECT_GE(spans[0].high, 1060 - 9.45);
  EXPECT_NEAR(spans[0].low, 1000 - 10.55, 0.03);
  EXPECT_NEAR(spans[0].high, 1060 - 9.45, 0.03);
}

TEST(ForbiddenByMap, LeavesOutWhatIsAlwaysThereOrElsewhere) {
  EXPECT_TRUE(
      forbidden_by_map(scene_of({{{-5, -5, -5}, {5, 5, 5}}}, {}), steady(), Parked::pad).empty());
  EXPECT_TRUE(
      forbidden_by_map(scene_of({{{-5, 5, -5}, {5, 9, 5}}}, {{0, 9}}), steady(), Parked::pad)
          .empty());
}

TEST(ForbiddenByMap, StandingOnAPadHasNoEnd) {
  const auto scene = scene_of({{{90, -5, -5}, {110, 5, 5}}}, {{1000, 1060}});
  const auto pad = forbidden_by_map(scene, steady(), Parked::pad);
  ASSERT_EQ(pad.size(), 1u);
  EXPECT_EQ(pad[0].low, -kForever);
  EXPECT_GE(pad[0].high, 1060 - 18.95);
  const auto gone = forbidden_by_map(scene, steady(), Parked::gone);
  ASSERT_EQ(gone.size(), 1u);
  EXPECT_NEAR(gone[0].low, 980, 0.01);
  EXPECT_LE(gone[0].low, 980);
}

// Halved down to hundredths of a second, each of these would be a hundred thousand million pieces.
TEST(ForbiddenByMap, TakesNoLongerForAFlightThatHoversForYears) {
  const auto hover = [](const Vec3& p, double seconds) {
    Segment segment;
    segment.duration = seconds;
    segment.point.fill(p);
    return Trajectory{{segment}};
  };
  const auto scene = scene_of({{{-5, -5, -5}, {5, 5, 5}}}, {{1000, 1060}});
  for (const double x : {0.0, scene.grown(0).max.x()}) {  // in the middle, and at the face
    const auto spans = forbidden_by_map(scene, hover({x, 0, 0}, 9e8), Parked::gone);
    ASSERT_EQ(spans.size(), 1u);
    EXPECT_LE(spans[0].low, 1000 - 9e8);
    EXPECT_NEAR(spans[0].low, 1000 - 9e8, 1e-3);
    EXPECT_GE(spans[0].high, 1060);
    EXPECT_NEAR(spans[0].high, 1060, 1e-3);
  }
}

// Whatever departure is left is proved by the check, and whatever it refuses is forbidden.
TEST(ForbiddenByMapProperty, HoldsEveryDepartureThatTheCheckRefuses) {
  support::Random random(81);
  int refused = 0;
  int accepted = 0;
  for (int i = 0; i < 150; ++i) {
    std::vector<geom::Aabb> boxes;
    std::vector<TimeSpan> times;
    for (int k = 0; k < 6; ++k) {
      const Vec3 low(random.uniform(-60, 50), random.uniform(-20, 15), random.uniform(-20, 15));
      boxes.push_back({low, low + Vec3(random.uniform(1, 20), 8, 8)});
      const double from = random.uniform(0, 300);
      times.push_back({random.below(5) ? from : -kForever,
                       random.below(5) ? from + random.uniform(0, 60) : kForever});
      if (times.back().always()) times.back().from = from;
    }
    const auto scene = scene_of(boxes, times);
    const Vec3 end(70, random.uniform(-9, 9), 0);
    const Trajectory flight{{hermite(rest({-70, 0, 0}), rest({0, 9, 3}), random.uniform(9, 30)),
                             hermite(rest({0, 9, 3}), rest(end), random.uniform(9, 30))}};
    const Parked parked = random.below(2) ? Parked::pad : Parked::gone;
    const auto spans = forbidden_by_map(scene, flight, parked);
    const auto ok = [&](double start) {
      CheckOptions options;
      options.start = start;
      options.stands = parked == Parked::pad;
      options.clearance = Clearance::left_out;
      return check(scene, flight, options).ok;
    };
    for (int k = 0; k < 40; ++k) {
      const double start = random.uniform(-100, 400);
      const bool is_ok = ok(start);
      ++(is_ok ? accepted : refused);
      ASSERT_TRUE(is_ok || holds(spans, start)) << i << ' ' << start;
    }
    for (const DepartureSpan& span : spans) {  // just beyond its ends
      ASSERT_TRUE(span.low < -1e9 || ok(std::nextafter(span.low, -kForever))) << i;
      ASSERT_TRUE(span.high > 1e9 || ok(std::nextafter(span.high, kForever))) << i;
    }
  }
  EXPECT_GT(refused, 300);
  EXPECT_GT(accepted, 300);
}

TEST(ForbiddenByMap, DeparturesWaitForItOrAreRefused) {
  const Trajectory flight = steady();
  FleetFlight one;
  one.trajectory = &flight;
  one.room = {1, 1, 1};
  one.earliest = 0;
  one.latest = 100;
  one.forbidden = {{-5, 3.0004}, {3.5, 20}};
  const std::vector<FleetFlight> flights{one};
  const FleetConflicts none = fleet_conflicts(flights, {}, Parked::gone);
  EXPECT_EQ(choose_departures(flights, none).of[0].start, 3.001);
  std::vector<FleetFlight> late{one};
  late[0].latest = 3;
  const Departures refused = choose_departures(late, none, {.improve = 2});
  EXPECT_FALSE(refused.of[0].start);
  EXPECT_TRUE(refused.of[0].blocked.empty());
}

}  // namespace
}  // namespace traj
