#include "traj/schedule/fleet_schedule.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "support/reading.h"

namespace traj {
namespace {

// 20 s along x, or along y, through the origin.
std::string record(const std::string& id, bool along_y,
                   const std::optional<double>& start = std::nullopt) {
  const Vec3 way = along_y ? Vec3(0, 100, 0) : Vec3(100, 0, 0);
  State begin;
  State end;
  begin.position = -way;
  end.position = way;
  TrajectoryRecord out;
  out.id = id;
  out.status = TrajectoryStatus::solved;
  out.trajectory = {{hermite(begin, end, 20)}};
  out.provenance.vehicle = geom::Vehicle{"box", {0.5, 0.5, 0.5}};
  out.provenance.margin = 0;
  out.time.start = start;
  return to_json_line(out);
}

struct Chosen {
  FleetStream stream;
  std::vector<FleetFlight> flights = {};
  FleetConflicts conflicts = {};
  Departures departures = {};
};

constexpr Parked kParked = Parked::gone;
const Spacing kSpacing{.zone = cylinder(3, 3), .downwash = {}};

// What is chosen for a stream, beside flights of others.
Chosen choose(const std::string& stream, double max_delay, const std::string& others = "") {
  Chosen out{.stream = FleetStream({.max_delay = max_delay}, {})};
  out.stream.read(support::Text(stream), "stream.jsonl");
  std::istringstream settled(others);
  if (!others.empty()) out.stream.read_others(settled, "others.jsonl");
  out.flights = out.stream.flights();
  out.conflicts = fleet_conflicts(out.flights, kSpacing, kParked);
  out.departures = choose_departures(out.flights, out.conflicts);
  return out;
}

struct Outcome {
  std::vector<std::string> records;
  nlohmann::json report;
  std::size_t refused = 0;
  bool together = false;
  std::string why;  // the first refused flight
};

Outcome outcome_of(const Chosen& chosen) {
  FleetObstacles none(chosen.stream, kParked, {});
  std::vector<FleetFlight> flights = chosen.flights;
  none.close(flights);
  const FleetSchedule schedule(
      {chosen.stream, none, chosen.flights, chosen.conflicts, chosen.departures}, kSpacing,
      kParked);
  const FleetProof proof = schedule.prove({});
  Outcome out{schedule.records(), nlohmann::json::parse(schedule.report(proof, 0)),
              schedule.refused(), proof.together.ok(), ""};
  for (std::uint32_t i = 0; i < chosen.stream.own() && out.why.empty(); ++i) {
    if (!chosen.departures.of[i].start) out.why = schedule.why_refused(i);
  }
  return out;
}

TEST(FleetSchedule, GivesEveryFlightADepartureWhereTheyMayWait) {
  const Outcome out = outcome_of(choose(record("a", false) + record("b", true), 600));
  EXPECT_EQ(out.refused, 0u);
  EXPECT_TRUE(out.together);
  ASSERT_EQ(out.records.size(), 2u);
  EXPECT_EQ(*parse_trajectory_record(out.records[0], "", 1).time.start, 0);
  EXPECT_GT(*parse_trajectory_record(out.records[1], "", 2).time.start, 0);
}

TEST(FleetSchedule, SaysForWhomAFlightIsRefused) {
  const Outcome out = outcome_of(choose(record("first", false) + record("second", true), 0));
  EXPECT_EQ(out.refused, 1u);
  EXPECT_TRUE(out.together) << "all that departs keeps apart";
  EXPECT_TRUE(support::says(out.why, "first"));
  EXPECT_NE(parse_trajectory_record(out.records[1], "", 2).status, TrajectoryStatus::solved);
}

TEST(FleetSchedule, KeepsApartFromFlightsOfOthersAndLeavesTheseWhereTheyAre) {
  const Outcome out = outcome_of(choose(record("own", false), 600, record("other", true, 0.0)));
  EXPECT_EQ(out.refused, 0u);
  ASSERT_EQ(out.records.size(), 1u) << "records are those of the stream";
  EXPECT_GT(*parse_trajectory_record(out.records[0], "", 1).time.start, 0);
}

TEST(FleetSchedule, TellsConflictsOfOthersFromItsOwn) {
  const Outcome out = outcome_of(
      choose(record("own", false, 0.0), 600, record("x", true, 900.0) + record("y", false, 900.0)));
  EXPECT_EQ(out.refused, 0u);
  EXPECT_FALSE(out.together);
}

TEST(FleetStream, RefusesAnIdTwiceAndOthersWithoutAStart) {
  EXPECT_NE(support::refusal_of([] { choose(record("a", false) + record("a", true), 9); }), "");
  EXPECT_NE(support::refusal_of([] { choose(record("a", false), 9, record("b", true)); }), "");
}

}  // namespace
}  // namespace traj
