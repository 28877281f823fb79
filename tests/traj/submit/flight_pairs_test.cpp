#include "traj/submit/flight_pairs.h"

#include <gtest/gtest.h>

#include "geom/base/error.h"
#include "traj/record/pair_summary.h"
#include "traj/scenes.h"

namespace traj {
namespace {

using testing::scene_of;

TrajectoryRecord flight(const std::string& id, double start) {
  TrajectoryRecord record{.id = id, .status = TrajectoryStatus::solved};
  record.trajectory.segments = {hermite({{0, 5, 5}}, {{9, 5, 5}}, 10)};
  record.time = {.epoch = "2026-05-04T06:30:00Z", .start = start};
  return record;
}

ComparedFlights compared(const std::vector<double>& starts) {
  const auto scene = scene_of({});
  FlightSet set({.spacing = {.zone = cylinder(1, 1)}, .parked = Parked::gone});
  for (std::size_t i = 0; i < starts.size(); ++i) {
    set.add(flight("q" + std::to_string(i), starts[i]), &scene, "t", i + 1);
  }
  return compare_flights(set);
}

TEST(CompareFlights, ProvesThatAllKeepApart) {
  const ComparedFlights made = compared({0, 5, 60});
  EXPECT_EQ(made.found, (FlightPairs{3, 0, {}}));
  EXPECT_TRUE(parse_together_record(made.records, "p", 1).ok);
  EXPECT_NE(made.certificates.find("\"type\":\"together\""), std::string::npos);
}

TEST(CompareFlights, NamesThoseThatComeTooNear) {
  const ComparedFlights made = compared({0, 60, 60.05});
  EXPECT_EQ(made.found, (FlightPairs{3, 1, {{"q1", "q2"}}}));
  EXPECT_TRUE(made.certificates.empty()) << "no reason is given where the answer is no";
  const std::string first = made.records.substr(0, made.records.find('\n'));
  EXPECT_EQ(parse_pair_record(first, "p", 1).second, "q2");
}

TEST(CompareFlights, NamesTheFirstOfVeryMany) {
  std::vector<double> starts;
  for (int i = 0; i < 10; ++i) starts.push_back(0.01 * i);
  const ComparedFlights made = compared(starts);
  EXPECT_EQ(made.found.refused, 45u);
  EXPECT_EQ(made.found.named.size(), kMostNamedPairs);
}

TEST(CompareFlights, RefusesAFlightThatItCannotCompare) {
  FlightSet set({.spacing = {.zone = cylinder(1, 1)}, .parked = Parked::gone});
  set.add(flight("q1", 0), static_cast<const geom::CollisionScene*>(nullptr), "t", 1);
  EXPECT_THROW(compare_flights(set), geom::InputError);
}

}  // namespace
}  // namespace traj
