#include "traj/flight/flight_log.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "geom/base/error.h"
#include "geom/base/random.h"
#include "support/reading.h"

namespace traj {
namespace {

using support::says;

std::string text_of(const std::vector<FlightLog>& logs) {
  std::ostringstream out;
  write_flight_log(out, logs);
  return out.str();
}

std::vector<FlightLog> read(const std::string& text) {
  return read_flight_log(support::Text(text), "log.csv");
}

std::string refusal(const std::string& text) {
  return support::refusal_of([&] { read(text); });
}

std::vector<FlightLog> random_flights(std::uint64_t seed) {
  geom::SplitMix64 random(seed);
  const auto vector = [&] {
    const double x = random.uniform(-1e3, 1e3);
    const double y = random.uniform(-1e-3, 1e-3);
    return geom::Vec3(x, y, random.uniform(0, 1));
  };
  std::vector<FlightLog> logs;
  for (const char* id : {"q1", "a,\"b\"", "", "ü"}) {
    logs.push_back({id, logs.size() % 2 ? "sha256:0123" : "", {}});
    for (int i = 0; i < 5; ++i) {
      FlightSample s;
      s.time = i * 0.01 + random.uniform(0, 0.009);
      s.position = vector();
      s.velocity = vector();
      s.attitude.coeffs() << vector(), random.uniform(-1, 1);
      s.attitude.normalize();
      s.body_rates = vector();
      s.setpoint_position = vector();
      s.setpoint_velocity = vector();
      s.setpoint_yaw = random.uniform(-10, 10);
      for (double& motor : s.motors) motor = random.uniform(0, 1);
      s.saturated = random.chance(0.5);
      logs.back().samples.push_back(s);
    }
  }
  return logs;
}

const std::string kHeader =
    "id,t_s,east_m,north_m,up_m,v_east_mps,v_north_mps,v_up_mps,qw,qx,qy,qz,p_radps,q_radps,r_"
    "radps,"
    "setpoint_east_m,setpoint_north_m,setpoint_up_m,setpoint_v_east_mps,setpoint_v_north_mps,"
    "setpoint_v_up_mps,setpoint_yaw_rad,motor1,motor2,motor3,motor4,saturated,map\n";

TEST(FlightLog, HasOneRowASample) {
  FlightLog log{"q1", "sha256:a", {FlightSample{}}};
  log.samples[0].motors = {0.25, 0.5, 0.75, 1};
  log.samples[0].saturated = true;
  EXPECT_EQ(text_of({log}),
            kHeader + "q1,0,0,0,0,0,0,0,1,0,0,0,0,0,0,0,0,0,0,0,0,0,0.25,0.5,0.75,1,1,sha256:a\n");
}

TEST(FlightLog, ComesBackBitForBit) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto logs = random_flights(seed);
    const auto back = read(text_of(logs));
    ASSERT_EQ(back.size(), logs.size()) << "seed " << seed;
    for (std::size_t i = 0; i < logs.size(); ++i) {
      EXPECT_EQ(back[i].id, logs[i].id);
      EXPECT_EQ(back[i].map, logs[i].map);
      ASSERT_EQ(back[i].samples.size(), logs[i].samples.size());
    }
    EXPECT_EQ(back[1].samples[3].attitude.coeffs(), logs[1].samples[3].attitude.coeffs());
    EXPECT_EQ(back[1].samples[3].setpoint_velocity, logs[1].samples[3].setpoint_velocity);
    EXPECT_EQ(text_of(back), text_of(logs)) << "seed " << seed;
  }
}

TEST(FlightLog, NamesItsMapInTheFirstRowOfAFlight) {
  const FlightLog log{"q", "sha256:a", {FlightSample{}, FlightSample{.time = 1}}};
  const std::string text = text_of({log});
  EXPECT_TRUE(says(text, ",0,sha256:a\nq,1,"));
  EXPECT_EQ(text.substr(text.size() - 3), "0,\n");
  const std::string again = text.substr(0, text.size() - 1) + "sha256:b\n";
  EXPECT_TRUE(says(refusal(again), "log.csv:3: the map must stand in the first row"));
}

TEST(FlightLog, IsReadWithCarriageReturnsAndBlankLines) {
  EXPECT_EQ(
      read(kHeader + "\r\nq,0,0,0,0,0,0,0,1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,\r\n\n").size(), 1);
}

TEST(FlightLog, RefusesWhatIsNotOne) {
  const std::string row =
      "q,0,0,0,0,0,0,0,1,0,0,0" + std::string(",0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,\n");
  EXPECT_TRUE(says(refusal(""), "expected the header id,t_s"));
  EXPECT_TRUE(says(refusal(kHeader), "at least one row"));
  EXPECT_TRUE(says(refusal(kHeader + "q,0,1\n"), "log.csv:2: expected 28 columns, found 3"));
  EXPECT_TRUE(says(refusal(kHeader + row + row), "log.csv:3: t_s must grow, found 0 after 0"));
  EXPECT_TRUE(
      says(refusal(kHeader + row + "p" + row.substr(1) + row), "must stand together; \"q\""));
  EXPECT_TRUE(says(refusal(kHeader + "q,0,nan" + row.substr(5)), "east_m must be a number from"));
  EXPECT_TRUE(says(refusal(kHeader + "q,0,1e9" + row.substr(5)), "east_m must be a number from"));
  EXPECT_TRUE(says(refusal(kHeader + "q,-1,0" + row.substr(5)), "t_s must be"));
  EXPECT_TRUE(
      says(refusal(kHeader + "q,0,0,0,0,0,0,0,1,1" + row.substr(19)), "a quaternion of length 1"));
  std::string saturated = row;
  saturated[saturated.size() - 3] = '2';
  EXPECT_TRUE(says(refusal(kHeader + saturated), "saturated must be a number from 0 to 1"));
}

TEST(FlightLog, RefusesACommentThatNamesOtherAxes) {
  const std::string text = text_of({{"q", "sha256:a", {FlightSample{}}}});
  EXPECT_EQ(read("# of Monday\n# ENU\n" + text).size(), 1u);
  EXPECT_TRUE(says(refusal("# frame: ned\n" + text), "log.csv:1: expected east, north and up, "));
}

TEST(FlightLog, RefusesIdsThatWouldNotComeBack) {
  for (const char* id : {"a\nb", " a", "a\t"}) {
    std::ostringstream out;
    EXPECT_THROW(write_flight(out, {id, "", {FlightSample{}}}), geom::InputError) << id;
  }
}

TEST(FlightLog, LeavesEmptyWhatIsNotKnown) {
  FlightLog log{"q", "", {nothing_known()}};
  log.samples[0].position = {1, 2, 3};
  const std::string row = "q,0,1,2,3,,,,,,,,,,,,,,,,,,,,,,,\n";
  EXPECT_EQ(text_of({log}), kHeader + row);
  const auto back = read(kHeader + row);
  EXPECT_EQ(back[0].samples[0].position, log.samples[0].position);
  EXPECT_FALSE(is_known(back[0].samples[0].velocity));
  EXPECT_FALSE(is_known(back[0].samples[0].setpoint_position));
  EXPECT_TRUE(std::isnan(back[0].samples[0].motors[3]));
  EXPECT_TRUE(std::isnan(back[0].samples[0].battery));
  EXPECT_EQ(text_of(back), kHeader + row);
}

TEST(FlightLog, HasBatteryAndEndWhereTheyAreKnown) {
  FlightLog log{"q", "sha256:a", {nothing_known(), nothing_known()}, true};
  log.samples[0].battery = 0.75;
  log.samples[1].time = 1;
  const std::string text = text_of({log});
  EXPECT_EQ(text, kHeader.substr(0, kHeader.size() - 1) +
                      ",battery_share,end\nq,0,0,0,0,,,,,,,,,,,,,,,,,,,,,,,sha256:a,0.75,\n"
                      "q,1,0,0,0,,,,,,,,,,,,,,,,,,,,,,,,,cut\n");
  const auto back = read(text);
  EXPECT_TRUE(back[0].cut);
  EXPECT_EQ(back[0].samples[0].battery, 0.75);
  EXPECT_TRUE(std::isnan(back[0].samples[1].battery));
  EXPECT_EQ(text_of(back), text);
  EXPECT_TRUE(
      says(refusal(text + "q,2,0,0,0,,,,,,,,,,,,,,,,,,,,,,,,,\n"), "the flight ended in the row"));
  EXPECT_TRUE(says(refusal(text.substr(0, text.size() - 2) + "x\n"), "end must be cut or empty"));
}

TEST(FlightLog, RefusesAPartOfAVector) {
  EXPECT_TRUE(says(refusal(kHeader + "q,0,1,2,3,,5,,,,,,,,,,,,,,,,,,,,,\n"),
                   "v_east_mps must be a number"));
  EXPECT_TRUE(
      says(refusal(kHeader + "q,0,1,2,,,,,,,,,,,,,,,,,,,,,,,,\n"), "up_m must be a number"));
  EXPECT_TRUE(says(refusal(kHeader + "q,0,1,2,3,,,,,,,,,,,,,,,,,,0.5,0.5,0.5,,,\n"),
                   "motor4 must be a number"));
}

}  // namespace
}  // namespace traj
