#include "cli/option/vehicle_word.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "support/reading.h"
#include "support/temporary_folder.h"

namespace cli {
namespace {

using geom::Limit;
using geom::Limits;
using geom::Vehicle;

class Profiles : public ::testing::Test {
 protected:
  traj::VehicleProfile parsed(const std::string& json) {
    const std::string path = folder_ / "v.json";
    std::ofstream(path) << json;
    return parse_vehicle(path);
  }
  std::string refused(const std::string& json) {
    return support::refusal_of([&] { parsed(json); });
  }
  support::TemporaryFolder folder_;
};

TEST_F(Profiles, HaveTheLimitsTheyStateAndThoseOfTheirMotors) {
  const traj::VehicleProfile profile =
      parsed(R"({"body":[1,1,0.5],"tilt_max_deg":35,"limits":{"vmax":12,"vmax_v":4},"mass_kg":2,)"
             R"("thrust_n":[0,30],"body_rate_max_rad_s":[3,4,2]})");
  const Limits& limits = profile.vehicle.limits;
  EXPECT_EQ(limits[Limit::speed], 12);
  EXPECT_EQ(limits[Limit::vertical_speed], 4);
  EXPECT_NEAR(*limits[Limit::tilt], 0.6108652381980153, 1e-15);
  EXPECT_EQ(limits[Limit::thrust], 15);
  EXPECT_EQ(limits[Limit::body_rate], 3);
  EXPECT_EQ(limits[Limit::yaw_rate], 2);
  EXPECT_EQ(profile.vehicle.half, geom::attitude_half_sizes({1, 1, 0.5}, *limits[Limit::tilt]));
}

TEST_F(Profiles, MayStateTighterLimitsThanTheirMotors) {
  const auto profile =
      parsed(R"({"body":[1,1,1],"limits":{"thrust":12,"tilt":0.5},"tilt_max_deg":35,"mass_kg":1,)"
             R"("thrust_n":[0,30]})");
  EXPECT_EQ(profile.vehicle.limits[Limit::thrust], 12);
  EXPECT_EQ(profile.vehicle.limits[Limit::tilt], 0.5);
  EXPECT_EQ(profile.vehicle.half, geom::attitude_half_sizes({1, 1, 1}, 0.5));
}

TEST_F(Profiles, WithoutATiltHaveABoxThatHoldsEveryAttitude) {
  const Vehicle vehicle = parsed(R"({"body":[0.3,0.4,0.2]})").vehicle;
  EXPECT_EQ(vehicle.limits, Limits{});
  const double reach = std::sqrt(0.09 + 0.16 + 0.04);
  EXPECT_GE(vehicle.half.x(), reach);
  EXPECT_GE(vehicle.half.z(), reach);
  EXPECT_NEAR(vehicle.half.z(), reach, 1e-12);
}

TEST_F(Profiles, AreRefusedWhereALimitWouldBePassedOver) {
  EXPECT_TRUE(
      support::says(refused(R"({"body":[1,1,1],"limit":{"vmax":3}})"), "\"limit\" is no key"));
  EXPECT_TRUE(support::says(refused(R"({"body":[1,1,1],"vmax":3})"), "\"vmax\" is no key"));
  EXPECT_TRUE(support::says(refused(R"({"body":[1,1,1],"limits":{"climb":3}})"), "\"climb\""));
  EXPECT_TRUE(support::says(refused(R"({"body":[1,1,1],"tilt_max_deg":0})"),
                            "above 0 and at most 80, found 0"));
}

TEST(Profile, IsTheSameByNameAndByFile) {
  for (const std::string name : {"tello", "crazyflie"}) {
    const auto file = std::string(SKYWAY_SOURCE_DIR) + "/data/vehicles/" + name + ".json";
    EXPECT_EQ(parse_vehicle(name).vehicle, parse_vehicle(file).vehicle) << name;
  }
}

TEST(Profile, OfABoxOrSphereLimitsNothing) {
  EXPECT_EQ(parse_vehicle("box:1,2,3").vehicle.limits, Limits{});
  EXPECT_EQ(parse_vehicle("sphere:1").vehicle.limits, Limits{});
}

}  // namespace
}  // namespace cli
