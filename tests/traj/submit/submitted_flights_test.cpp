#include "traj/submit/submitted_flights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/reading.h"
#include "support/small_map.h"
#include "traj/record/trajectory_record.h"
#include "traj/submit/flight_parts.h"

namespace traj {
namespace {

constexpr double kCell = 20;

// Ground that is flat up to x = 0, and rises by 6 cm for each metre east of it.
geom::GroundModel ramp(double slope = 0.06, double zero = 0, double hole_from = 1e9) {
  geom::GroundGridSpec spec;
  spec.corner = {-1000, -1000};
  spec.cell = kCell;
  spec.columns = spec.rows = 100;
  spec.hash = "sha256:ramp";
  std::vector<double> low;
  std::vector<double> high;
  for (std::size_t k = 0; k < spec.columns * spec.rows; ++k) {
    const double x = spec.corner.x() + kCell * static_cast<double>(k % spec.columns);
    const bool hole = x >= hole_from;
    low.push_back(hole ? NAN : zero + slope * std::max(x, 0.0));
    high.push_back(hole ? NAN : zero + slope * std::max(x + kCell, 0.0));
  }
  return {spec, low, high};
}

// 60 m above terrain, 200 m to the east, and back.
std::string mission(const char* frame = "10") {
  std::string out = "QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t47\t8\t400\t1\n";
  out += "1\t0\t3\t22\t0\t0\t0\t0\t47\t8\t60\t1\n2\t0\t2\t178\t0\t3\t0\t0\t0\t0\t0\t1\n";
  for (const char* place :
       {"3\t0\tF\t16\t2\t0\t0\t0\t47\t8.002634\t60\t1\n", "4\t0\tF\t16\t2\t0\t0\t0\t47\t8\t60\t1\n",
        "5\t0\tF\t21\t0\t0\t0\t0\t47\t8\t0\t1\n"}) {
    std::string line = place;
    line.replace(line.find('F'), 1, frame);
    out += line;
  }
  return out;
}

// A map, a method, and what comes of a mission there.
struct Desk {
  Desk() {
    method.origin = {47, 8, 400};
    method.ground = 0;
    method.terrain_error = 0;
    method.risk.dimension = 0.7;
    method.limits[Limit::speed] = 9;
    method.begins = "2026-05-04T06:30:00Z";
    method.ends = "2026-05-04T07:00:00Z";
  }

  const SubmittedFlight& fly(const geom::GroundModel* ground, const std::string& text = mission()) {
    MethodFiles files;
    files.ground = ground;
    open.emplace(scenes, method, files);
    flights = open->of_mission(text, "t.waypoints");
    return *flights.front().flight;
  }

  std::string refusal_with(const geom::GroundModel* ground) {
    return support::refusal_of([&] { fly(ground); });
  }

  geom::BoxMap map = support::map_of({{-900, -900, 0}, {900, 900, 300}}, {});
  geom::Scenes scenes{map,
                      {geom::Vehicle{"cube", Vec3::Constant(0.5)}, 0.2},
                      geom::Differences::refused,
                      1ULL << 30};
  SubmissionMethod method;
  std::optional<SubmittedFlights> open;
  std::vector<FlightInScene> flights;
};

geom::IntentVolumes read_back(const geom::IntentVolumes& intent) {
  return geom::read_intent_volumes(support::Text(volumes_json(intent)), "v");
}

// m above the map's z = 0.
double top(const geom::IntentVolumes& intent) {
  double most = 0;
  for (const geom::Volume4d& one : intent.nominal) most = std::max(most, *one.upper - 400);
  return most;
}

double bottom(const geom::IntentVolumes& intent) {
  double least = 1e9;
  for (const geom::Volume4d& one : intent.nominal) least = std::min(least, *one.lower - 400);
  return least;
}

TEST(SubmittedFlights, TakeAMissionAboveTerrainAsABandOfHeights) {
  Desk desk;
  const geom::GroundModel ground = ramp();
  const SubmittedFlight& one = desk.fly(&ground);
  ASSERT_EQ(one.refusal(), "");
  ASSERT_TRUE(one.report().terrain);
  const geom::IntentVolumes intent = read_back(one.intent());
  EXPECT_EQ(one.why_not_held(intent), std::nullopt);
  EXPECT_GE(top(intent), 60 + 12 + 0.7) << "12 m of ground, and the vehicle with its margin";
  const FlightClaims claims = one.claims(intent, risk_volumes(intent, one.risk_task(), "t"));
  ASSERT_TRUE(claims.terrain);
  EXPECT_EQ(claims.terrain->model, "sha256:ramp");
}

TEST(SubmittedFlights, VolumesThatCutTheBandAreRefused) {
  Desk desk;
  const geom::GroundModel ground = ramp();
  const SubmittedFlight& one = desk.fly(&ground);
  const geom::IntentVolumes whole = read_back(one.intent());
  geom::IntentVolumes low = whole;
  geom::IntentVolumes high = whole;
  for (std::size_t i = 0; i < whole.nominal.size(); ++i) {
    low.nominal[i].upper = std::min(*whole.nominal[i].upper, 400 + top(whole) - 0.1);
    high.nominal[i].lower = std::max(*whole.nominal[i].lower, 400 + bottom(whole) + 0.1);
  }
  EXPECT_TRUE(one.why_not_held(low));
  EXPECT_TRUE(one.why_not_held(high));
}

TEST(SubmittedFlights, AMissionAboveTerrainNeedsTheErrorOfItsTerrain) {
  Desk desk;
  const geom::GroundModel ground = geom::GroundModel::flat(0);
  desk.method.terrain_error.reset();
  desk.method.surface = SurfaceBand{40, 70};
  EXPECT_TRUE(support::says(desk.refusal_with(&ground), "give --terrain-error"));
}

TEST(SubmittedFlights, SayWhetherAMissionEndsWithAReturn) {
  Desk desk;
  desk.method.terrain_error.reset();
  std::string text = mission("3");
  desk.fly(nullptr, text);
  EXPECT_FALSE(desk.flights.front().ends_at_home);
  text.replace(text.find("\t21\t"), 4, "\t20\t");
  desk.fly(nullptr, text);
  EXPECT_TRUE(desk.flights.front().ends_at_home);
}

TEST(TerrainUse, NamesWhatNoMissionUses) {
  SubmissionMethod method;
  method.terrain_error = 3;
  method.surface = SurfaceBand{40, 70};
  TerrainUse use;
  ReportRecord report;
  use.take(report);
  EXPECT_EQ(use.idle(method), "terrain_error");
  report.terrain = TerrainClaim{.model = "flat", .error = 3};
  use.take(report);
  EXPECT_EQ(use.idle(method), "surface_band");
  report.terrain = TerrainClaim{.model = "flat", .surface = {{40, 70}}};
  use.take(report);
  EXPECT_FALSE(use.idle(method));
  EXPECT_FALSE(TerrainUse().idle({}));
}

TEST(SubmittedFlights, MoreTerrainErrorIsHigherVolumes) {
  Desk desk;
  const geom::GroundModel ground = ramp();
  const double exact = top(desk.fly(&ground).intent());
  desk.method.terrain_error = 5;
  EXPECT_GE(top(desk.fly(&ground).intent()), exact + 10) << "at home and below";
}

TEST(SubmittedFlights, AMissionOverRisingGroundTakesLonger) {
  Desk desk;
  const geom::GroundModel level = ramp(0);
  const geom::GroundModel rising = ramp();
  const double flat = desk.fly(&level).duration();
  EXPECT_GT(flat, 60 / 2.5 + 400 / 3.0 + 60 / 1.5);
  EXPECT_NEAR(desk.fly(&rising).duration(), flat + 2 * 12 / 1.5, 2);
  desk.method.ends = "2026-05-04T06:32:00Z";
  EXPECT_TRUE(support::says(desk.fly(&rising).refusal(), "--between leaves it 120 s"));
}

TEST(SubmittedFlights, AMissionAboveTerrainNeedsItsGround) {
  Desk desk;
  EXPECT_TRUE(support::says(desk.refusal_with(nullptr),
                            "t.waypoints:5: expected heights above sea level or home, found one "
                            "above terrain"));
  const geom::GroundModel hole = ramp(0.06, 0, 300);
  EXPECT_TRUE(support::says(desk.refusal_with(&hole), "expected a height model that knows"));
  geom::GroundGridSpec other = ramp().spec();
  other.frame.axes = geom::Axes::neu;
  const std::vector<double> heights(other.columns * other.rows, 0.0);
  const geom::GroundModel turned(other, heights, heights);
  EXPECT_TRUE(support::says(desk.refusal_with(&turned), "expected the ground of this map"));
  const geom::GroundModel high = ramp(0.06, 500);
  EXPECT_TRUE(support::says(desk.refusal_with(&high), "do both count from the same zero?"));
}

TEST(SubmittedFlights, AMissionAboveTerrainHasNoReturnsFromAnywhere) {
  Desk desk;
  desk.method.risk.contingency = ContingencyRule::ways_home;
  const geom::GroundModel ground = ramp();
  EXPECT_EQ(desk.fly(&ground).refusal(),
            "over terrain nobody knows how high a return begins: leave --contingency return out");
}

TEST(SubmittedFlights, GroundThatTheFloorDeniesRefusesEachFlight) {
  Desk desk;
  const geom::GroundModel ground = ramp();
  EXPECT_EQ(flight_parts(desk.fly(&ground), desk.map).refusal, "");
  desk.method.floor = 0.5;
  for (const char* frame : {"10", "3"}) {
    EXPECT_TRUE(support::says(flight_parts(desk.fly(&ground, mission(frame)), desk.map).refusal,
                              "the ground below is as low as z 0.0 by the height model"));
  }
  EXPECT_EQ(flight_parts(desk.fly(nullptr, mission("3")), desk.map).refusal, "")
      << "without a model nobody knows";
}

TEST(SubmittedFlights, GroundThatTheFloorDeniesRefusesTrajectories) {
  Desk desk;
  const geom::CollisionScene scene(desk.map, geom::Vehicle{"cube", Vec3::Constant(0.5)}, 0.2);
  TrajectoryRecord record{.id = "q1", .status = TrajectoryStatus::solved};
  record.trajectory.segments = {hermite({{0, 0, 60}}, {{20, 0, 60}}, 10)};
  record.provenance = geom::provenance_of(scene);
  record.time = {.epoch = "2026-05-04T06:30:00Z", .start = 0};
  const geom::GroundModel ground = ramp();
  MethodFiles files{.ground = &ground};
  for (const double floor : {0.0, 0.5}) {
    desk.method.floor = floor;
    const SubmittedFlights open(desk.scenes, desk.method, files);
    const FlightInScene one = open.of_record(to_json_line(record), "flights.jsonl", 1);
    const std::string refusal = flight_parts(*one.flight, desk.map).refusal;
    if (floor == 0) {
      EXPECT_EQ(refusal, "");
    } else {
      EXPECT_TRUE(support::says(refusal, "the ground below is as low as z 0.0")) << refusal;
    }
  }
}

}  // namespace
}  // namespace traj
