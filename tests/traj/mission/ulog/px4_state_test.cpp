#include "mission/ulog/px4_state.h"

#include <gtest/gtest.h>

#include "ulog_bytes.h"

namespace traj {
namespace {

TEST(Px4State, HoldsAValueForASecondEitherWay) {
  Logged<double> value;
  EXPECT_FALSE(value.at(0));
  value.set(5'000'000, 3.5);
  EXPECT_EQ(value.at(5'000'000), 3.5);
  EXPECT_EQ(value.at(6'000'000), 3.5);
  EXPECT_FALSE(value.at(6'000'001));
  EXPECT_EQ(value.at(4'000'000), 3.5);  // the file's order is not quite that of the times
  EXPECT_FALSE(value.at(3'999'999));
}

TEST(Px4State, ForgetsWhatIsNotKnownAnyMore) {
  Logged<double> value;
  value.set(0, 3.5);
  value.set(1, std::nullopt);
  EXPECT_FALSE(value.at(1));
}

// A state that took one message of a topic with these fields.
Px4State after(const char* topic, const std::string& fields, const std::string& bytes) {
  UlogFormats formats("log.ulg");
  formats.add(std::string(topic) + ":uint64_t timestamp;" + fields);
  const UlogLayout layout = formats.layout(topic);
  Px4State state;
  state.take(UlogMessage(topic, layout, bytes_of(std::uint64_t{7}) + bytes));
  return state;
}

std::string floats(std::initializer_list<float> values) {
  std::string out;
  for (const float value : values) out += bytes_of(value);
  return out;
}

TEST(Px4State, TakesAttitudesOfLengthOne) {
  const auto attitude = [](std::initializer_list<float> q) {
    return after("vehicle_attitude", "float[4] q;", floats(q)).attitude.at(7);
  };
  EXPECT_NEAR(attitude({0.6f, 0, 0, 0.8f})->w(), 0.6, 1e-7);
  EXPECT_NEAR(attitude({0.6f, 0, 0, 0.8f})->z(), 0.8, 1e-7);
  EXPECT_FALSE(attitude({0, 0, 0, 0}));
  EXPECT_FALSE(attitude({1, 1, 0, 0}));
}

TEST(Px4State, TakesRatesOfOldLogsFromTheAttitude) {
  const Px4State state =
      after("vehicle_attitude", "float rollspeed;float pitchspeed;float yawspeed;float[4] q;",
            floats({1, 2, 3, 1, 0, 0, 0}));
  EXPECT_EQ(state.body_rates.at(7), geom::Vec3(1, 2, 3));
}

TEST(Px4State, TakesABatteryThatIsThere) {
  const auto battery = [](float share, bool connected) {
    return after("battery_status", "float remaining;bool connected;",
                 bytes_of(share) + bytes_of(connected))
        .battery.at(7);
  };
  EXPECT_EQ(battery(0.5f, true), 0.5);
  EXPECT_FALSE(battery(0.5f, false));
  EXPECT_FALSE(battery(-1, true));
  EXPECT_FALSE(battery(1.5f, true));
}

TEST(Px4State, TakesNoVectorBeyondAFlight) {
  EXPECT_FALSE(
      after("vehicle_angular_velocity", "float[3] xyz;", floats({0, 2e6f, 0})).body_rates.at(7));
}

}  // namespace
}  // namespace traj
