#include "traj/mission/formats/tello.h"

#include <gtest/gtest.h>

#include <numbers>
#include <sstream>

#include "geom/base/error.h"
#include "support/reading.h"
#include "traj/scenes.h"

namespace traj {
namespace {

using testing::Random;

constexpr double kQuarter = std::numbers::pi / 2;

TEST(Tello, FliesInTheDronesAxes) {
  const std::vector<Vec3> points = {{10, 20, 1}, {10, 23, 1}, {11, 23, 2}};
  const auto legs = [&](double heading) {
    return tello_flight(points, {{10, 20, 0}, heading, 1}, 50, true).legs;
  };
  using Legs = std::vector<TelloLeg>;
  EXPECT_EQ(legs(0), (Legs{{300, 0, 0, 50}, {0, -100, 100, 50}}));             // nose north
  EXPECT_EQ(legs(kQuarter), (Legs{{0, 300, 0, 50}, {100, 0, 100, 50}}));       // east
  EXPECT_EQ(legs(2 * kQuarter), (Legs{{-300, 0, 0, 50}, {0, 100, 100, 50}}));  // south
  EXPECT_EQ(legs(-kQuarter), (Legs{{0, -300, 0, 50}, {-100, 0, 100, 50}}));    // west
}

TEST(Tello, SplitsLongLegsAndPassesOverNearPoints) {
  const std::vector<Vec3> points = {{0, 0, 1}, {0, 0.15, 1}, {0, 12, 1}, {0.1, 12.1, 1}};
  const TelloFlight flight = tello_flight(points, {{0, 0, 0}, 0, 1}, 100, true);
  ASSERT_EQ(flight.legs.size(), 3u) << "12.1 m in three, straight to the end";
  const geom::Polyline path = tello_path(flight, {{0, 0, 0}, 0, 1});
  EXPECT_LT((path.back() - Vec3(0.1, 12.1, 1)).norm(), 1e-12);
}

TEST(Tello, RoundingNeverAddsUp) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const TelloStart start{random.vector(20), random.number(-4, 4), 1};
    std::vector<Vec3> points = {start.ground + Vec3(0, 0, 1)};
    for (int k = 0; k < 300; ++k) points.push_back(points.back() + Vec3(0.3337, 0, 0));
    const TelloFlight flight = tello_flight(points, start, 100, true);
    const geom::Polyline path = tello_path(flight, start);
    ASSERT_EQ(path.size(), points.size()) << "case " << i;
    for (std::size_t k = 0; k < path.size(); ++k) {
      EXPECT_LE((path[k] - points[k]).norm(), 0.005 * std::sqrt(2.0) + 1e-9) << "case " << i;
    }
  }
}

TEST(Tello, EveryMoveIsOneTheSdkTakesAndTheScriptComesBack) {
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    const TelloStart start{Vec3::Zero(), random.number(-4, 4), 1};
    std::vector<Vec3> points = {{0, 0, 1}};
    for (int k = 0; k < 20; ++k) points.push_back(points.back() + random.vector(i % 2 ? 20 : 0.3));
    const TelloFlight flight = tello_flight(points, start, 73, i % 3 > 0);
    std::stringstream script;
    write_tello(script, flight);
    const TelloFlight back = read_tello(script, "t.txt");  // refuses what the SDK would
    EXPECT_EQ(back.legs, flight.legs);
    EXPECT_EQ(back.lands, flight.lands);
    if (flight.legs.empty()) continue;
    EXPECT_LT((tello_path(flight, start).back() - points.back()).norm(), 0.01) << "case " << i;
  }
}

TEST(Tello, TimesAreOfATrapezoidAndARest) {
  const TelloFlight flight{{{100, 0, 0, 50}, {0, 25, 0, 100}}, true};
  const auto times = tello_times(flight, {Vec3::Zero(), 0, 1});
  ASSERT_EQ(times.size(), 3u);
  EXPECT_DOUBLE_EQ(times[0], 3);                   // 1 m at 0.5 m/s, and 1 s
  EXPECT_DOUBLE_EQ(times[1] - times[0], 2.5 + 1);  // 0.5 s up, 1.5 s, 0.5 s down
  EXPECT_DOUBLE_EQ(times[2] - times[1], 1 + 1);    // never at full speed
}

std::string refusal(const std::string& text) {
  return support::refusal_of([&] { read_tello(support::Text(text), "t.txt"); });
}

TEST(Tello, BadScriptsAreRefused) {
  EXPECT_EQ(refusal("takeoff\ngo 100 0 0 10"),
            "t.txt:2: expected a line that ends with LF, found none: the file may be cut");
  EXPECT_EQ(refusal("command\ntakeoff\ngo 100 0 0 50\nland\n"), "");
  EXPECT_EQ(refusal(""), "t.txt: expected a takeoff, found none");
  EXPECT_EQ(refusal("command\r\ntakeoff\r\n"), "") << "as Windows ends lines";
  EXPECT_EQ(refusal("\xef\xbb\xbf"
                    "command\ntakeoff\n"),
            "");
  EXPECT_EQ(refusal("command\r\r\ntakeoff\r\n"),
            "t.txt:1: expected command or takeoff, found \"command\r\"");
  EXPECT_EQ(refusal("go 100 0 0 50\n"),
            "t.txt:1: expected command or takeoff, found \"go 100 0 0 50\"");
  EXPECT_EQ(refusal("takeoff\ngo 501 0 0 50\n"),
            "t.txt:2: a move must be within -500 to 500 cm, found 501");
  EXPECT_EQ(refusal("takeoff\ngo 20 -20 20 50\n"),
            "t.txt:2: a move must go beyond 20 cm on one axis, found 20 -20 20");
  EXPECT_EQ(refusal("takeoff\ngo 100 0 0 9\n"),
            "t.txt:2: a speed must be within 10 to 100 cm/s, found 9");
  for (const char* bad : {"go 100,5 0 0 50", "go 1 2 3", "go 100 0 0 50 m1", "go 1e2 0 0 50",
                          "go 99999999999 0 0 50"}) {
    EXPECT_EQ(refusal(std::string("takeoff\n") + bad + "\n"),
              std::string("t.txt:2: expected go and four whole numbers, found \"") + bad + "\"");
  }
  EXPECT_EQ(refusal("takeoff\nland\ngo 100 0 0 50\n"),
            "t.txt:3: expected nothing after land, found \"go 100 0 0 50\"");
  EXPECT_EQ(refusal("takeoff\nflip l\n"),
            "t.txt:2: expected go x y z speed or land, found \"flip l\"");
}

}  // namespace
}  // namespace traj
