#include "traj/record/simulated_flights.h"

#include <gtest/gtest.h>

#include "support/reading.h"
#include "traj/flights.h"
#include "traj/scenes.h"

namespace traj {
namespace {

TrajectoryRecord record(const std::string& id, double seconds) {
  TrajectoryRecord out;
  out.id = id;
  out.status = TrajectoryStatus::solved;
  out.trajectory = testing::line({5, 0, 0}, seconds);
  return out;
}

TrajectoryRecord without_way(const std::string& id) {
  TrajectoryRecord out;
  out.id = id;
  out.status = TrajectoryStatus::no_path;
  return out;
}

SimulationOptions options() {
  SimulationOptions out;
  out.flight = testing::example_flight();
  out.profile.vehicle = {"box", {0.2, 0.2, 0.1}};
  return out;
}

std::string stream() {
  return to_json_line(record("a", 4)) + to_json_line(without_way("none")) +
         to_json_line(record("b", 5));
}

std::vector<SimulatedFlight> fly(SimulatedFlights& flights) {
  std::vector<SimulatedFlight> out;
  flights.fly({4, {}}, [&](SimulatedFlight one) { out.push_back(std::move(one)); });
  return out;
}

TEST(SimulatedFlights, GivesAFlightARecordInOrder) {
  SimulatedFlights flights(options(), nullptr);
  EXPECT_EQ(flights.read(support::Text(stream()), "s", {}), 3u);
  const auto flown = fly(flights);
  ASSERT_EQ(flown.size(), 3u);
  EXPECT_EQ(flown[0].report.id, "a");
  EXPECT_EQ(flown[1].report.status, TrajectoryStatus::no_path);
  EXPECT_FALSE(flown[1].seconds);
  EXPECT_TRUE(flown[1].log.samples.empty());
  EXPECT_DOUBLE_EQ(flown[2].report.duration, 5);
  EXPECT_FALSE(flown[2].log.samples.empty());
}

TEST(SimulatedFlights, TakesWhatItsShardTakes) {
  SimulatedFlights flights(options(), nullptr);
  EXPECT_EQ(flights.read(support::Text(stream()), "s", {.index = 2, .count = 3}), 3u)
      << "all of the stream are counted";
  const auto flown = fly(flights);
  ASSERT_EQ(flown.size(), 1u);
  EXPECT_EQ(flown[0].report.id, "b");
}

TEST(SimulatedFlights, RefusesAnIdThatComesTwice) {
  SimulatedFlights flights(options(), nullptr);
  const std::string twice = stream() + to_json_line(record("a", 3));
  EXPECT_EQ(support::refusal_of([&] { flights.read(support::Text(twice), "s", {}); }),
            "s:4: expected each id once, found \"a\" again: give each trajectory an id of its own");
}

TEST(SimulatedFlights, RefusesFlightsOfMoreThanTenHours) {
  SimulatedFlights flights(options(), nullptr);
  EXPECT_TRUE(support::says(support::refusal_of([&] {
                              flights.read(support::Text(to_json_line(record("long", 36001))), "s",
                                           {});
                            }),
                            "at most 36000 s"));
}

TEST(SimulatedFlights, TunesOnlyWhereThereIsATrajectory) {
  SimulatedFlights flights(options(), nullptr);
  flights.read(support::Text(to_json_line(without_way("none"))), "s", {});
  EXPECT_TRUE(
      support::says(support::refusal_of([&] { flights.tune({}, {}); }), "solved trajectory"));
}

// A slab above the flight, higher than the body's half size at the profile's tilt and lower than at
// the tilt that the flight takes.
TEST(SimulatedFlights, HoldTubesAgainstTheMapAtTheTiltThatIsFlown) {
  const Vec3 body(0.4, 0.4, 0.05);
  for (const double most : {0.05, 0.9}) {
    SimulationOptions asked = options();
    asked.flight.law = ControlLaw::geometric;
    asked.profile.body = body;
    asked.profile.vehicle = {"plate", geom::attitude_half_sizes(body, 0.05)};
    asked.profile.vehicle.limits[geom::Limit::tilt] = most;
    if (most > 0.5) asked.profile.vehicle.limits[geom::Limit::tilt].reset();
    asked.spread = MonteCarloOptions{3, 0};
    asked.disturbances = Disturbances{};
    asked.tube = true;
    const geom::CollisionScene place =
        testing::scene_of({{{-5, -5, 0.2}, {10, 5, 1}}}, {{-50, -50, -50}, {50, 50, 50}});
    geom::Scenes scenes(place.map(), {asked.profile.vehicle, 0.0}, geom::Differences::allowed,
                        1u << 30);
    SimulatedFlights flights(asked, &scenes);
    flights.read(support::Text(to_json_line(record("a", 3))), "s", {});
    const auto flown = fly(flights);
    ASSERT_EQ(flown.size(), 1u);
    const FlightReport& report = flown[0].report;
    ASSERT_TRUE(report.tube_check && report.proved_check);
    EXPECT_GT(report.tube.tilt, 0.2);
    EXPECT_GE(report.proved.tilt, report.tube.tilt - 1e-9);
    // Without a limit the half sizes are said to hold at every tilt.
    EXPECT_EQ(report.tube_check->clear, most > 0.5);
    EXPECT_EQ(report.proved_check->clear, most > 0.5);
  }
}

}  // namespace
}  // namespace traj
