#include "mission/firmware/mission_drift.h"

#include <gtest/gtest.h>

#include "geom/shape/hull.h"
#include "geom/shape/polyline.h"

namespace traj {
namespace {

// A mission's way: straight legs, with a turn at each point.
struct Way {
  geom::Polyline path;
  std::vector<double> hold;
  std::vector<FlightPart> legs;
  std::vector<Turn> turns;
  std::vector<std::optional<double>> speeds;
  VerticalEnds ends;
  std::vector<Vec3> rally;
  double return_height = 0;
  std::vector<Sweep> sweeps;

  Way& go(const Vec3& p, const Turn& turn, double seconds = 0, double speed = 8,
          Manoeuvre manoeuvre = Manoeuvre::leg) {
    path.push_back(p);
    hold.push_back(seconds);
    legs.push_back({path.size(), manoeuvre});
    turns.push_back(turn);
    speeds.emplace_back(speed);
    return *this;
  }

  std::vector<Sweep> drift(const Autopilot& autopilot) const {
    const DriftTask task{
        path, hold,  legs,         turns, speeds, sweeps, {path.size() + 1, Manoeuvre::landing},
        ends, rally, return_height};
    return drift_of(autopilot, task).sweeps;
  }
};

const Turn kRest{.said = 2};
const Turn kPass{Turn::pass, 2, 2, 2};

// Whether some sweep holds the point.
bool holds(const std::vector<Sweep>& sweeps, const Vec3& p) {
  const Vec3 hair = Vec3::Constant(1e-6);
  for (const Sweep& sweep : sweeps) {
    if (geom::hull_meets(sweep.hull, {p - hair, p + hair})) return true;
  }
  return false;
}

Way corner(const Turn& turn, double hold = 0, double speed = 8) {
  Way way;
  way.ends = {0.0, 0.0};
  way.go({0, 0, 20}, {}, 0, speed, Manoeuvre::takeoff).go({100, 0, 20}, turn, hold, speed);
  way.go({100, 100, 20}, kRest, 5, speed);
  return way;
}

TEST(Drift, PassesATakeOffBelowItsHeight) {
  const auto sweeps = corner(kRest, 5).drift(px4());
  EXPECT_TRUE(holds(sweeps, {0, 0, 10})) << "the way up";
  EXPECT_TRUE(holds(sweeps, {0.5, 0, 19.3})) << "NAV_MC_ALT_RAD";
  EXPECT_FALSE(holds(sweeps, {0.5, 0, 19.1}));
  EXPECT_FALSE(holds(corner(kRest, 5).drift(ardupilot()), {20, 0, 19.9}));
}

TEST(Drift, ClimbsToTheLeastTakeOff) {
  Way low;
  low.ends = {0.0, 0.0};
  low.go({0, 0, 1}, {}, 0, 8, Manoeuvre::takeoff).go({50, 0, 1}, kRest, 5);
  EXPECT_TRUE(holds(low.drift(px4()), {0, 0, 2.5})) << "MIS_TAKEOFF_ALT";
  EXPECT_FALSE(holds(low.drift(ardupilot()), {0, 0, 1.5}));
}

TEST(Drift, OvershootsAStopByItsSpeed) {
  const auto sweeps = corner(kRest, 5).drift(ardupilot());
  EXPECT_TRUE(holds(sweeps, {100 + 0.12 * 8 + 0.099, 0, 20}));
  EXPECT_FALSE(holds(sweeps, {100 + 0.12 * 8 + 0.101, 0, 20}));
  EXPECT_TRUE(holds(sweeps, {100.5, 5, 20})) << "the next leg begins while it is still off";
  const auto with_drag = [](double drag) {
    Autopilot pilot = px4();
    set_drag(pilot, drag);
    return corner(kRest, 5).drift(pilot);
  };
  EXPECT_FALSE(holds(with_drag(0.1), {100.01, 0, 20}));
  EXPECT_TRUE(holds(with_drag(0.5), {100 + 0.25 * 0.4 * 8 - 0.001, 0, 20}));
  EXPECT_FALSE(holds(with_drag(0.5), {100 + 0.25 * 0.4 * 8 + 0.001, 0, 20}));
  EXPECT_FALSE(holds(corner(kRest, 5, 2).drift(ardupilot()), {100.4, 0, 20})) << "slowly";
}

TEST(Drift, ClimbsAheadOfItsPlaceWithMuchDrag) {
  Way way;
  way.ends = {0.0, 0.0};
  way.go({0, 0, 20}, {}, 0, 6, Manoeuvre::takeoff).go({60, 0, 30}, kRest, 5, 6);
  Autopilot pilot = px4();
  EXPECT_TRUE(holds(way.drift(pilot), {2, 0, 21.1})) << "6 m to the full speed: 1 m up";
  EXPECT_FALSE(holds(way.drift(pilot), {2, 0, 22}));
  EXPECT_TRUE(holds(way.drift(pilot), {55, 0, 30}));
  set_drag(pilot, 0.1);
  EXPECT_FALSE(holds(way.drift(pilot), {55, 0, 30}));
}

TEST(Drift, LeavesASplineByWhatAStopIsOvershot) {
  Way way = corner(kRest, 5);
  way.sweeps = {{{{0, 50, 20}, {50, 50, 20}}, {3, Manoeuvre::spline}}};
  EXPECT_TRUE(holds(way.drift(ardupilot()), {25, 50 + 0.12 * 8 + 0.09, 20}));
  EXPECT_FALSE(holds(way.drift(ardupilot()), {25, 50 + 0.12 * 8 + 0.11, 20}));
  way.sweeps[0].part.manoeuvre = Manoeuvre::circle;
  EXPECT_FALSE(holds(way.drift(ardupilot()), {25, 50.1, 20}));
}

TEST(Drift, SwingsLessBehindSharpTurns) {
  const auto aside = [](const Vec3& corner, const Vec3& end) {
    Way way;
    way.ends = {0.0, 0.0};
    way.go({0, 0, 20}, {}, 0, 12, Manoeuvre::takeoff).go(corner, kPass, 0, 12);
    way.go(end, kRest, 5, 12);
    Autopilot pilot = px4();
    set_drag(pilot, 0.1);
    const Vec3 out = (end - corner).normalized();
    const Vec3 right(out.y(), -out.x(), 0);
    double reach = 0;
    while (holds(way.drift(pilot), corner + 20 * out + (reach + 0.1) * right)) reach += 0.1;
    return reach;
  };
  EXPECT_NEAR(aside({200, 0, 20}, {390, 60, 20}), 0.013 * 144, 0.1);
  EXPECT_LT(aside({200, 0, 20}, {200, 200, 20}), 1.3);
}

TEST(Drift, SlowsDownOnlyOnAWayThatIsLongEnough) {
  Way way;
  way.ends = {0.0, 0.0};
  way.go({0, 0, 20}, {}, 0, 8, Manoeuvre::takeoff)
      .go({100, 0, 20}, kPass)
      .go({103, 0, 20}, kRest, 5, 1);
  EXPECT_TRUE(holds(way.drift(ardupilot()), {103.9, 0, 20})) << "3 m are no way to slow down on";
  way.path.back().x() = 140;
  EXPECT_FALSE(holds(way.drift(ardupilot()), {140.3, 0, 20}));
}

TEST(Drift, CutsCornersWithinTheRadiusOrByTheSCurve) {
  const auto px = corner(kPass).drift(px4());
  EXPECT_TRUE(holds(px, {99, 0.9, 20}));
  EXPECT_FALSE(holds(px, {97, 1, 20}));
  EXPECT_TRUE(holds(px, {99.2, 30, 20})) << "it comes to the new leg slowly";
  const auto ardu = corner(kPass).drift(ardupilot());
  EXPECT_TRUE(holds(ardu, {85, 0.4, 20})) << "22.8 m before the corner, whatever the item says";
  EXPECT_TRUE(holds(ardu, {100 - 1.4, 1.4, 20}));
  EXPECT_FALSE(holds(ardu, {100 - 1.5, 1.5, 20})) << "WPNAV_RADIUS";
  EXPECT_TRUE(holds(ardu, {100.9, 10, 20})) << "and swings outward behind it";
}

TEST(Drift, TakesAShortLegBetweenTwoCornersForNone) {
  Way way;
  way.ends = {0.0, 0.0};
  way.go({0, 0, 20}, {}, 0, 8, Manoeuvre::takeoff).go({100, 0, 20}, kPass).go({100, 8, 20}, kPass);
  way.go({0, 8, 20}, kRest, 5);
  EXPECT_TRUE(holds(way.drift(px4()), {97, 5, 20}));
  way.path[2].y() = way.path[3].y() = 30;
  EXPECT_FALSE(holds(way.drift(px4()), {97, 5, 20}));
}

TEST(Drift, OfTwoPointsHasNothingBehindIt) {
  Way way;
  way.ends = {0.0, 0.0};
  way.go({0, 0, 20}, {}, 0, 8, Manoeuvre::takeoff);
  way.go({0, 0, 50}, {}, 0, 8, Manoeuvre::return_home);
  way.go({0, 0, 50}, {}, 0, 8, Manoeuvre::return_home);
  EXPECT_TRUE(holds(way.drift(ardupilot()), {0, 0, 40}));
}

TEST(Drift, LeavesTheLineBeforeATightRadius) {
  Turn tight = kRest;
  tight.said = 0.2;
  EXPECT_TRUE(holds(corner(tight, 5).drift(px4()), {50, 3.2, 23.2}));
  EXPECT_FALSE(holds(corner(tight, 5).drift(px4("1.11")), {50, 0.1, 20}));
  EXPECT_FALSE(holds(corner(tight, 5).drift(ardupilot()), {50, 0.1, 20}));
  EXPECT_FALSE(holds(corner(kRest, 5).drift(px4()), {50, 0.1, 20}));
}

TEST(Drift, SinksBeforeItIsAboveALandingElsewhere) {
  Way way = corner(kPass);
  way.go({140, 100, 20}, {}, 0, 8, Manoeuvre::landing);
  Autopilot near = px4();
  near.acceptance = 2;
  const auto sweeps = way.drift(near);
  EXPECT_TRUE(holds(way.drift(px4()), {132, 100, 19})) << "10 m, where no parameter says less";
  EXPECT_TRUE(holds(sweeps, {138.5, 100, 18.5}));
  EXPECT_TRUE(holds(sweeps, {140, 100, 1}));
  EXPECT_FALSE(holds(sweeps, {138.5, 100, 10}));
  EXPECT_FALSE(holds(corner(kRest, 5).drift(px4()), {100, 98.5, 18.5})) << "from a rest";
}

// A return from (100, 0, 20): up to 50 m and back above the take-off.
Way homeward() {
  Way way;
  way.ends = {0.0, 0.0};
  way.go({0, 0, 20}, {}, 0, 8, Manoeuvre::takeoff).go({100, 0, 20}, kRest, 5);
  way.go({100, 0, 50}, {}, 0, 8, Manoeuvre::return_home);
  way.go({0, 0, 50}, {}, 0, 8, Manoeuvre::return_home);
  return way;
}

TEST(Drift, ReturnsFromWhereItStopped) {
  const auto sweeps = homeward().drift(ardupilot());
  EXPECT_TRUE(holds(sweeps, {101, 0, 49})) << "beyond its last stop all the way up";
  EXPECT_TRUE(holds(sweeps, {-1, 0, 50})) << "and beyond home";
  EXPECT_FALSE(holds(sweeps, {101.1, 0, 49}));
  EXPECT_TRUE(holds(sweeps, {99, 0, 49})) << "it turns from the climb by an S-curve";
  EXPECT_TRUE(holds(sweeps, {99.5, 0, 49.8})) << "and up to the top, beside what it overshot";
  EXPECT_FALSE(holds(sweeps, {90, 0, 45}));
}

TEST(Drift, SinksBeforeItIsAboveHomeAndAboveARallyPoint) {
  Way way = homeward();
  way.rally = {{50, 80, 30}};
  way.return_height = 50;
  Autopilot near = px4();
  near.acceptance = 2;
  const auto sweeps = way.drift(near);
  EXPECT_TRUE(holds(sweeps, {1.5, 0, 48}));
  const Vec3 from = (Vec3(100, 0, 80) - Vec3(50, 80, 80)).normalized();
  EXPECT_TRUE(holds(sweeps, Vec3(50, 80, 79) + 1.5 * from)) << "as high above the rally point";
  EXPECT_FALSE(holds(sweeps, Vec3(50, 80, 65) + 1.5 * from));
}

TEST(Drift, ReturnsOnALineToTheHeightOfDescentUntil115) {
  Way way = homeward();
  way.rally = {{50, 80, 30}};
  way.return_height = 50;
  const Vec3 from = 1.5 * (Vec3(100, 0, 80) - Vec3(50, 80, 80)).normalized();
  for (const auto& [version, aslant] : {std::pair{"1.15", true}, {"1.17", false}}) {
    Autopilot near = px4(version);
    near.acceptance = 2;
    const auto sweeps = way.drift(near);
    EXPECT_EQ(holds(sweeps, Vec3(50, 80, 73) + from), aslant) << "10 m above the rally point: 40";
    EXPECT_EQ(holds(sweeps, {1.2, 0, 35}), aslant) << "and above home";
    EXPECT_FALSE(holds(sweeps, {1.2, 0, 8}));
  }
  Autopilot waits = px4("1.17");
  waits.descends_aslant = true;
  EXPECT_TRUE(holds(way.drift(waits), {1.2, 0, 35}));
}

TEST(Drift, ClimbsToARallyPointFromWhereHomeAsksForNoClimb) {
  Way way;
  way.go({0, 0, 20}, {}, 0, 8, Manoeuvre::takeoff).go({100, 0, 20}, kRest, 5);
  way.go({0, 0, 20}, {}, 0, 8, Manoeuvre::return_home);
  way.rally = {{50, 80, 30}};
  EXPECT_TRUE(holds(way.drift(ardupilot()), {101, 0, 29}));
  EXPECT_TRUE(holds(way.drift(ardupilot()), {50, 80, 30}));
}

TEST(Drift, ClimbsToTheHeightOfItsWayToARallyPoint) {
  Way way = homeward();
  way.return_height = 50;
  way.rally = {{50, 80, 30}};
  EXPECT_TRUE(holds(way.drift(px4()), {100, 0, 80})) << "PX4: 50 m above the rally point";
  EXPECT_TRUE(holds(way.drift(px4()), {50, 80, 80}));
  EXPECT_FALSE(holds(way.drift(px4()), {50, 80, 81}));
  EXPECT_FALSE(holds(way.drift(ardupilot()), {50, 80, 52}));
  way.rally = {{50, 80, 70}};
  EXPECT_TRUE(holds(way.drift(ardupilot()), {101, 0, 69})) << "ArduPilot: the higher of both";
}

TEST(Drift, StandsOnTheGround) {
  const auto sweeps = corner(kRest, 5).drift(px4());
  std::size_t columns = 0;
  for (const Sweep& sweep : sweeps) columns += sweep.stands_on.has_value();
  EXPECT_EQ(columns, 3u) << "the way up, the way down, and how it begins to sink";
}

}  // namespace
}  // namespace traj
