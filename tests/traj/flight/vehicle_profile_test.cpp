#include "traj/flight/vehicle_profile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/refusal.h"

namespace traj {
namespace {

TEST(VehicleProfile, IsTheBoxThatHoldsTheBodyAtEveryTiltItMayHave) {
  const VehicleProfile profile = parse_vehicle_profile(
      R"({"name":"kite","body":[3,4,0],"limits":{"tilt":1,"vmax":8},"tilt_max_deg":30})", "k");
  EXPECT_EQ(profile.vehicle.name, "kite");
  EXPECT_EQ(profile.body, geom::Vec3(3, 4, 0));
  EXPECT_NEAR(*profile.vehicle.limits[geom::Limit::tilt], M_PI / 6, 1e-15) << "the stricter";
  EXPECT_EQ(profile.vehicle.limits[geom::Limit::speed], 8);
  EXPECT_LT((profile.vehicle.half - geom::Vec3(5, 5, 2.5)).norm(), 1e-12);
  EXPECT_FALSE(profile.airframe.mass);
}

TEST(VehicleProfile, LimitsAreNeverMoreThanItsMotorsGive) {
  const VehicleProfile profile = parse_vehicle_profile(
      R"({"body":[1,1,1],"mass_kg":2,"thrust_n":[0,30],"body_rate_max_rad_s":[3,4,2],)"
      R"("limits":{"thrust":20,"body_rate":1}})",
      "file.json");
  EXPECT_EQ(profile.vehicle.name, "file.json") << "without a name, the source";
  EXPECT_EQ(profile.vehicle.limits[geom::Limit::thrust], 15);
  EXPECT_EQ(profile.vehicle.limits[geom::Limit::body_rate], 1);
  EXPECT_EQ(profile.vehicle.limits[geom::Limit::yaw_rate], 2);
}

TEST(VehicleProfile, RefusesWhatIsNoKeyAndWhatIsNoBody) {
  const auto said = [](const char* json) {
    return support::refusal_of([&] { parse_vehicle_profile(json, "v.json"); });
  };
  EXPECT_NE(said(R"({"body":[1,1,1],"max_speed":3})").find("\"max_speed\""), std::string::npos);
  EXPECT_TRUE(said("{}").starts_with("v.json: "));
  EXPECT_NE(said(R"({"body":[1,-1,1]})").find("body"), std::string::npos);
  EXPECT_NE(said(R"({"body":[1,1,1],"tilt_max_deg":81})").find("tilt_max_deg"), std::string::npos);
}

TEST(VehicleNamed, IsOneOfTheNamesInAlphabeticalOrder) {
  const auto names = vehicle_names();
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  EXPECT_TRUE(std::binary_search(names.begin(), names.end(), "tello"));
  for (const std::string_view name : names) {
    const auto profile = vehicle_named(name);
    ASSERT_TRUE(profile) << name;
    EXPECT_GT(profile->vehicle.half.minCoeff(), 0) << name;
  }
  EXPECT_FALSE(vehicle_named("tello.json"));
  EXPECT_FALSE(vehicle_named(""));
}

}  // namespace
}  // namespace traj
