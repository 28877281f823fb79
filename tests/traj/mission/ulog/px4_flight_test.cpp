#include "traj/mission/ulog/px4_flight.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "support/reading.h"
#include "traj/mission/ulog/flight_notes.h"
#include "traj/mission/ulog/px4_projection.h"
#include "ulog_bytes.h"

namespace traj {
namespace {

using geom::Vec3;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

enum Topic : std::uint16_t {
  kLocal,
  kGlobal,
  kAttitude,
  kRates,
  kSetpoint,
  kOldSetpoint,
  kBattery,
  kMotors,
  kLanded
};

// A log with all topics, to which messages are added.
struct Log {
  std::string bytes = ulog_head();
  float north = 1;  // m/s

  Log() {
    add("vehicle_local_position", kLocal,
        "double ref_lat;double ref_lon;float x;float y;float z;float vx;float vy;float vz;float "
        "ref_alt;bool xy_valid;bool z_valid;bool v_xy_valid;bool v_z_valid;bool xy_global;bool "
        "z_global;uint8_t xy_reset_counter;");
    add("vehicle_global_position", kGlobal, "double lat;double lon;float alt;float alt_ellipsoid;");
    add("vehicle_attitude", kAttitude, "float[4] q;");
    add("vehicle_angular_velocity", kRates, "float[3] xyz;");
    add("trajectory_setpoint", kSetpoint, "float[3] position;float[3] velocity;float yaw;");
    add("vehicle_local_position_setpoint", kOldSetpoint,
        "float x;float y;float z;float vx;float vy;float vz;float yaw;");
    add("battery_status", kBattery, "float remaining;bool connected;");
    add("actuator_motors", kMotors, "float[12] control;");
    add("vehicle_land_detected", kLanded, "bool landed;");
  }

  void add(const std::string& name, Topic topic, const std::string& fields) {
    bytes += ulog_message('F', name + ":uint64_t timestamp;" + fields) + ulog_topic(name, topic);
  }

  template <class... Values>
  Log& row(Topic topic, double seconds, Values... values) {
    const auto time = static_cast<std::uint64_t>(std::llround(1e6 * seconds));
    bytes += ulog_data(topic, bytes_of(time) + (bytes_of(values) + ... + std::string()));
    return *this;
  }

  Log& local(double seconds, const Vec3& ned, bool valid = true, bool global = true,
             double latitude = 47, std::uint8_t resets = 0) {
    return row(kLocal, seconds, latitude, 8.0, float(ned.x()), float(ned.y()), float(ned.z()),
               north, 2 * north, 3 * north, 400.f, valid, valid, valid, valid, global, global,
               resets);
  }

  Log& standing() {  // from now on
    north = 0;
    return *this;
  }

  Px4Flight read(const Px4Options& options = {}) const {
    return read_px4_flight(support::Text(bytes), "log.ulg", options);
  }
};

TEST(Px4Flight, TurnsNorthEastDownIntoEastNorthUp) {
  const Px4Flight flight =
      Log().local(10, {1, 2, -3}, true, false).local(10.5, {2, 2, -3}, true, false).read();
  ASSERT_EQ(flight.log.samples.size(), 2u);
  EXPECT_EQ(flight.topic, "vehicle_local_position");
  EXPECT_FALSE(flight.reference);
  EXPECT_EQ(flight.log.samples[0].time, 0);
  EXPECT_EQ(flight.log.samples[1].time, 0.5);
  EXPECT_EQ(flight.log.samples[0].position, Vec3(2, 1, 3));
  EXPECT_EQ(flight.log.samples[0].velocity, Vec3(2, 1, -3));
}

TEST(Px4Flight, IsPlacedByItsReference) {
  const Log log = Log().local(0, {1000, 500, -20});
  const geom::GeodeticOrigin origin{47.01, 8.01, 430};
  const Px4Flight flight = log.read({MissionFrame{origin, 50}});
  geom::GeodeticPlace place = px4_place({47, 8, 400}, 1000, 500);
  place.height += 50 + 20;
  EXPECT_LT((flight.log.samples.at(0).position - geom::GeographicFrame(origin).enu(place)).norm(),
            1e-6);
  // The ellipsoid's metres: half a kilometre east is longer there than on PX4's sphere.
  EXPECT_NEAR(log.read().log.samples.at(0).position.x(), 501.47, 0.02);
}

TEST(Px4Flight, IsPlacedByEachReferenceInTurn) {
  const Px4Flight flight =
      Log().local(0, {0, 0, 0}).local(1, {0, 0, 0}, true, true, 47.001, 1).read();
  const Vec3 step = flight.log.samples.at(1).position - flight.log.samples.at(0).position;
  EXPECT_NEAR(step.y(), 111.17, 0.02);
  EXPECT_EQ(flight.resets, 1u);
  EXPECT_NEAR(flight.largest_reset, (step - Vec3(2, 1, -3)).norm(), 0.01) << "but for what it flew";
}

// A flight from the ground to the ground whose velocity is (1, 2, 3) m/s; its estimate is corrected
// by 3 m south where it is in the air, or before that.
Px4Flight corrected(double takes_off, double north, double reference = 47) {
  Log log;
  const auto landed = [&](double at, bool value) { log.row(kLanded, at, std::uint8_t(value)); };
  landed(0, true);
  log.local(0, {0, 0, 0});
  if (takes_off < 1) landed(takes_off, false);
  log.local(0.5, {0.5, 1, 1.5}).local(1, {1 + north, 2, 3}, true, true, reference, 1);
  if (takes_off > 1) landed(takes_off, false);
  landed(2, true);
  return log.local(1.9, {1.9 + north, 3.8, 5.7}, true, true, reference, 1).read();
}

TEST(Px4Flight, IsCutWhereItsPlaceIsCorrectedInTheAir) {
  const Px4Flight flight = corrected(0.2, -3);
  EXPECT_NEAR(flight.largest_reset_in_air, 3, 1e-3);
  EXPECT_TRUE(flight.corrected_in_air && flight.log.cut);
  EXPECT_FALSE(corrected(0.2, -0.9).log.cut) << "0.9 m";
  const Px4Flight before = corrected(1.2, -3);
  EXPECT_FALSE(before.corrected_in_air || before.log.cut) << "on the ground";
  EXPECT_NEAR(before.largest_reset, 3, 1e-3);
}

TEST(Px4Flight, IsCutWhereItsReferenceMovesInTheAir) {
  Log log;
  log.row(kLanded, 0, std::uint8_t(1)).local(0, {0, 0, 0}).row(kLanded, 0.1, std::uint8_t(0));
  log.local(0.2, {0.2, 0.4, 0.6}).local(0.3, {0.3, 0.6, 0.9}, true, true, 47.0001);
  const Px4Flight flight = log.row(kLanded, 0.4, std::uint8_t(1)).read();
  EXPECT_EQ(flight.resets, 1u);
  EXPECT_NEAR(flight.largest_reset_in_air, 11.1, 0.1);
  EXPECT_TRUE(flight.log.cut);
}

TEST(Px4Flight, LeavesOutWhatIsNotKnown) {
  const Px4Flight flight = Log()
                               .local(0, {0, 0, 0}, false)
                               .local(1, {1, 0, 0})
                               .local(2, {kNan, 0, 0})
                               .local(1, {9, 9, 9})
                               .local(3, {1, 0, 0}, true, false)
                               .local(4, {2, 0, 0})
                               .read({MissionFrame{{47, 8, 0}, 0}});
  EXPECT_EQ(flight.log.samples.size(), 2u);
  EXPECT_EQ(flight.positions, 6u);
  EXPECT_EQ(flight.not_known, 2u);
  EXPECT_EQ(flight.nowhere, 1u);
  EXPECT_EQ(flight.back, 1u);
  EXPECT_EQ(flight.log.samples[1].time, 3);
  EXPECT_TRUE(Log().local(0, {0, 0, 0}).read({MissionFrame{{-30, 8, 0}, 0}}).log.samples.empty());
}

TEST(Px4Flight, TurnsTheAttitude) {
  // Nose east, rolled to the right by 0.2: in PX4's axes yaw pi / 2.
  const Eigen::Quaterniond q = Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ()) *
                               Eigen::Quaterniond(Eigen::AngleAxisd(0.2, Vec3::UnitX()));
  const Px4Flight flight =
      Log()
          .row(kAttitude, 0, float(q.w()), float(q.x()), float(q.y()), float(q.z()))
          .row(kRates, 0, 1.f, 2.f, 3.f)
          .local(0.1, {0, 0, 0}, true, false)
          .read();
  const FlightSample& s = flight.log.samples.at(0);
  EXPECT_LT((s.attitude * Vec3::UnitX() - Vec3::UnitX()).norm(), 1e-6);  // forward is east
  const Vec3 left = s.attitude * Vec3::UnitY();  // rolled to the right: the left side is up
  EXPECT_LT((left - Vec3(0, std::cos(0.2), std::sin(0.2))).norm(), 1e-6);
  EXPECT_GE(s.attitude.w(), 0);
  EXPECT_EQ(s.body_rates, Vec3(1, -2, -3));
}

TEST(Px4Flight, TakesSetpointsOfBothKinds) {
  const float yaw = static_cast<float>(std::numbers::pi / 2);  // east
  Log log;
  log.row(kOldSetpoint, 0, 1.f, 2.f, -3.f, 4.f, 5.f, -6.f, yaw).local(0.1, {0, 0, 0}, true, false);
  log.row(kSetpoint, 0.2, 7.f, 8.f, -9.f, kNan, kNan, kNan, 0.f).local(0.3, {0, 0, 0}, true, false);
  log.row(kSetpoint, 0.4, kNan, kNan, -9.f, 1.f, 0.f, 0.f, 0.f).local(0.5, {0, 0, 0}, true, false);
  const auto samples = log.read().log.samples;
  ASSERT_EQ(samples.size(), 3u);
  EXPECT_EQ(samples[0].setpoint_position, Vec3(2, 1, 3));
  EXPECT_EQ(samples[0].setpoint_velocity, Vec3(5, 4, 6));
  EXPECT_NEAR(samples[0].setpoint_yaw, 0, 1e-7);
  EXPECT_EQ(samples[1].setpoint_position, Vec3(8, 7, 9));
  EXPECT_FALSE(is_known(samples[1].setpoint_velocity));
  EXPECT_NEAR(samples[1].setpoint_yaw, std::numbers::pi / 2, 1e-7);
  EXPECT_EQ(samples[2].setpoint_position, Vec3(2, 1, 3));  // of the two that which says one
}

TEST(Px4Flight, HoldsAValueForASecond) {
  Log log;
  log.row(kBattery, 0, 0.5f, true)
      .local(0.9, {0, 0, 0}, true, false)
      .local(1.1, {0, 0, 0}, true, false);
  const auto samples = log.read().log.samples;
  EXPECT_EQ(samples.at(0).battery, 0.5);
  EXPECT_TRUE(std::isnan(samples.at(1).battery));
  EXPECT_FALSE(is_known(samples.at(1).setpoint_position));
  EXPECT_TRUE(std::isnan(samples.at(1).motors[0]));
}

TEST(Px4Flight, TakesFourMotorsOnly) {
  const auto motor = [](float fifth) {
    Log log;
    log.row(kMotors, 0, 0.1f, 0.2f, 0.3f, 0.4f, fifth, kNan, kNan, kNan, kNan, kNan, kNan, kNan);
    return log.local(0, {0, 0, 0}, true, false).read().log.samples.at(0).motors;
  };
  EXPECT_NEAR(motor(kNan)[3], 0.4, 1e-7);
  EXPECT_TRUE(std::isnan(motor(0.5f)[0]));
}

TEST(Px4Flight, TakesGlobalPositionsWithoutLocalOnes) {
  Log log;
  log.row(kGlobal, 0, 47.0, 8.0, 400.f, 448.f).row(kGlobal, 1, 47.001, 8.0, 410.f, 458.f);
  log.row(kSetpoint, 0.9, 1.f, 1.f, 1.f, 0.f, 0.f, 0.f, 0.f);
  const Px4Flight flight = log.read();
  EXPECT_EQ(flight.topic, "vehicle_global_position");
  ASSERT_EQ(flight.log.samples.size(), 2u);
  EXPECT_EQ(flight.log.samples[0].position, Vec3(0, 0, 0));
  EXPECT_NEAR(flight.log.samples[1].position.y(), 111.17, 0.02);
  EXPECT_NEAR(flight.log.samples[1].position.z(), 10, 1e-9);
  EXPECT_FALSE(is_known(flight.log.samples[1].setpoint_position));  // it counts from elsewhere
  EXPECT_NEAR(*flight.sea_level, 48, 1e-9);
}

TEST(Px4Flight, KnowsTheTakeOff) {
  Log log;
  log.row(kLanded, 0, true)
      .local(1, {0, 0, 0})
      .row(kLanded, 1.5, false)
      .local(2, {0, 0, -1})
      .local(3, {0, 0, -2});
  Px4Flight flight = log.read();
  EXPECT_NEAR(flight.takeoff.value(), 0.5, 1e-12);
  begin_at(0.5, flight);
  ASSERT_EQ(flight.log.samples.size(), 2u);
  EXPECT_EQ(flight.log.samples[0].time, 0.5);
  EXPECT_EQ(flight.takeoff, 0);
  EXPECT_FALSE(Log().row(kLanded, 0, false).local(1, {0, 0, 0}).read().takeoff);
}

TEST(Px4Flight, SaysWhereTheLogBreaksOff) {
  Log log;
  log.standing().local(0, {0, 0, 0}).local(1, {0, 0, 0});
  EXPECT_FALSE(log.read().log.cut);
  log.bytes.pop_back();
  EXPECT_TRUE(log.read().log.cut);
  EXPECT_EQ(log.read().log.samples.size(), 1u);
}

TEST(Px4Flight, IsCutWherePositionsAtItsEndAreLeftOut) {
  const auto log = [] { return Log().standing().local(1, {0, 0, 0}).local(2, {0, 0, 0}); };
  const Px4Flight lost = log().local(3, {9, 0, 0}, false).read();
  EXPECT_TRUE(lost.log.cut);
  EXPECT_EQ(lost.left_out_at_end, 1u);
  EXPECT_TRUE(log().local(3, {kNan, 0, 0}).read().log.cut);
  EXPECT_TRUE(log().local(1.5, {9, 0, 0}).read().log.cut);
  EXPECT_FALSE(log().local(3, {9, 0, 0}, false).local(4, {0, 0, 0}).read().log.cut);
}

TEST(Px4Flight, IsCutWhereItFliesBeforeItsFirstPosition) {
  const auto first_at = [](double seconds, bool valid) {
    return [=](Log log) {
      return log.local(0.5, {0, 0, 0}, valid).local(seconds, {9, 0, -9}).read();
    };
  };
  const auto lost = first_at(5, false);
  const Log took_off = Log().row(kLanded, 0, true).row(kLanded, 3, false);
  const Px4Flight flight = lost(took_off);
  EXPECT_TRUE(flight.begins_in_air);
  EXPECT_EQ(flight.left_out_at_begin, 1u);
  EXPECT_TRUE(flight.log.cut);
  EXPECT_TRUE(lost(Log()).log.cut) << "nothing says that it stood";
  EXPECT_TRUE(lost(Log().row(kLanded, 0, false)).log.cut);
  EXPECT_TRUE(lost(Log(took_off).row(kLanded, 4, true)).log.cut) << "flew and landed unseen";
  EXPECT_FALSE(lost(Log().row(kLanded, 0, true)).log.cut) << "it stood";
  EXPECT_TRUE(first_at(1, true)(Log().row(kLanded, 0, false)).log.cut) << "begins in the air";
  EXPECT_FALSE(
      first_at(1, true)(Log().row(kLanded, 0, true).row(kLanded, 0.8, false)).begins_in_air);
}

// As a log does that was cut exactly between two messages.
TEST(Px4Flight, IsCutWhereItEndsInTheAir) {
  const auto flown = [] {
    return Log().row(kLanded, 0, true).local(1, {0, 0, 0}).row(kLanded, 2, false);
  };
  const Px4Flight flight = flown().local(3, {0, 0, -5}).read();
  EXPECT_TRUE(flight.ends_in_air);
  EXPECT_TRUE(flight.log.cut);
  EXPECT_FALSE(flown().local(3, {0, 0, -5}).row(kLanded, 3.1, true).read().log.cut);
}

TEST(Px4Flight, IsCutWhereItMovesAtAnEndAndNothingSaysThatItStood) {
  const auto read = [](bool moves_first, bool moves_last) {
    Log log;
    if (!moves_first) log.standing();
    log.local(1, {0, 0, 0});
    log.north = moves_last ? 1 : 0;
    return log.local(2, {0, 0, -5}).read();
  };
  const Px4Flight unknown = read(false, false);
  EXPECT_FALSE(unknown.log.cut || unknown.tells_landed);
  EXPECT_TRUE(support::says(warnings(unknown, {}).at(0), "does not say when the vehicle stands"));
  EXPECT_TRUE(read(true, false).begins_in_air && read(true, false).log.cut);
  EXPECT_TRUE(read(false, true).ends_in_air && read(false, true).log.cut);
}

TEST(Px4Flight, IsCutWhereOtherTopicsGoOnWithoutPositions) {
  const auto battery_at = [](double seconds) {
    return Log().standing().local(1, {0, 0, 0}).row(kBattery, seconds, 0.5f, true).read();
  };
  EXPECT_FALSE(battery_at(1.9).log.cut);
  EXPECT_TRUE(battery_at(2.1).log.cut);
  EXPECT_TRUE(battery_at(2.1).ends_silent);
}

TEST(Px4Flight, IsCutWhereItBeginsAfterItsTakeOff) {
  const auto begun = [](double begin, bool lands) {
    Log log;
    log.standing();
    if (lands) log.row(kLanded, 0, true).local(1, {0, 0, 0}).row(kLanded, 2, false);
    log.local(3, {0, 0, -1}).local(4, {0, 0, -2}).local(5, {0, 0, -3});
    if (lands) log.row(kLanded, 5.1, true);
    Px4Flight flight = log.read();
    EXPECT_EQ(begin_at(begin, flight), flight.log.cut);
    return flight.log.cut;
  };
  EXPECT_FALSE(begun(0, true));
  EXPECT_FALSE(begun(1, true));
  EXPECT_TRUE(begun(1.5, true));
  EXPECT_FALSE(begun(0, false));
  EXPECT_TRUE(begun(1.5, false)) << "nothing says when it took off";
}

TEST(Px4Flight, EndsWhereItsClockIsSetBack) {
  Log log;
  log.local(10, {0, 0, 0}).local(11, {0, 0, 0});
  // 8 s of the flight, and then a time that seems to be soon after the last row.
  log.local(3, {9, 0, 0}).local(11.5, {0, 0, 0});
  const Px4Flight flight = log.read();
  EXPECT_EQ(flight.log.samples.size(), 2u);
  EXPECT_EQ(flight.left_out_at_end, 2u);
  EXPECT_TRUE(flight.log.cut);
}

TEST(Px4Flight, HasNoSamplesWithoutPositions) {
  EXPECT_TRUE(Log().read().log.samples.empty());
  EXPECT_EQ(Log().local(0, {0, 0, 0}, false).read().not_known, 1u);
}

TEST(Px4Flight, TakesOffFromTheGroundThatIsGiven) {
  const auto log = [](bool takes_off) {
    Log out;
    out.row(kLanded, 0, true).local(1, {0, 0, 0}).local(2, {0, 0, -1});
    if (takes_off) out.row(kLanded, 2.5, false);
    return out.local(3, {0, 0, -5}).local(4, {0, 0, -9}).read({MissionFrame{{47, 8, 0}, 0, false}});
  };
  Px4Flight flight = log(true);
  EXPECT_NEAR(take_off_from(7, flight, "log.ulg"), 400, 1e-6);
  const auto& samples = flight.log.samples;
  ASSERT_EQ(samples.size(), 4u);
  EXPECT_NEAR(samples[0].position.z(), 7, 1e-6);
  EXPECT_NEAR(samples[1].position.z(), 8, 1e-6) << "it rises before that is noticed";
  EXPECT_NEAR(samples[3].position.z(), 16, 1e-6);
  flight = log(false);
  EXPECT_EQ(support::refusal_of([&] { take_off_from(7, flight, "log.ulg"); }),
            "log.ulg: expected a take-off after the first position, from whose ground the heights "
            "would count, found none");
}

}  // namespace
}  // namespace traj
