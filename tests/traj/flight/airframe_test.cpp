#include "traj/flight/airframe.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "flight/airframe_record.h"
#include "geom/text/json_fields.h"
#include "support/reading.h"

namespace traj {
namespace {

Airframe parse(const std::string& json) {
  return parse_airframe(geom::JsonFields(json, "v.json", 0));
}

std::string refusal(const std::string& json) {
  return support::refusal_of([&] { parse(json); });
}

TEST(Airframe, IsWhatTheProfileSays) {
  const Airframe a = parse(
      R"({"mass_kg":2,"inertia_kg_m2":[1,2,3],"thrust_n":[1,30],"body_rate_max_rad_s":[4,5,6]})");
  EXPECT_EQ(a.mass, 2);
  EXPECT_EQ(a.inertia, geom::Vec3(1, 2, 3));
  EXPECT_EQ(a.thrust_least, 1);
  EXPECT_EQ(a.thrust_most, 30);
  EXPECT_EQ(a.body_rate_max, geom::Vec3(4, 5, 6));
  EXPECT_FALSE(a.motor_time_constant);
}

TEST(Airframe, RefusesWhatCannotBe) {
  EXPECT_TRUE(support::says(refusal(R"({"mass_kg":0})"), "mass_kg must be > 0, found 0"));
  EXPECT_TRUE(support::says(refusal(R"({"mass_kg":"2"})"), "mass_kg must be a finite number"));
  EXPECT_TRUE(
      support::says(refusal(R"({"inertia_kg_m2":[1,1,3]})"), "at most the sum of the other two"));
  EXPECT_TRUE(support::says(refusal(R"({"thrust_n":[3,2]})"), "0 <= least < most, found [3,2]"));
  EXPECT_TRUE(support::says(refusal(R"({"mass_kg":2,"thrust_n":[0,19]})"),
                            "more than the weight, 19.61 N"));
  EXPECT_TRUE(support::says(refusal(R"({"body_rate_max_rad_s":[1,-1,1]})"), "> 0 about each axis"));
}

constexpr const char* kWhole =
    R"("mass_kg":2,"inertia_kg_m2":[1,2,3],"thrust_n":[2,30],"motor_time_constant_s":0.1,)"
    R"("motor_arm_m":[0.1,0.2],"torque_per_thrust_m":0.02)";

TEST(Airframe, IsAQuadrotorWhereAllIsKnownThatFlightTakes) {
  const Airframe a = parse(std::string("{") + kWhole + R"(,"drag_kg_s":[0.1,0.2,0]})");
  const auto q = quadrotor_of(a);
  ASSERT_TRUE(q);
  EXPECT_EQ(q->motor_least, 0.5);
  EXPECT_EQ(q->motor_most, 7.5);
  EXPECT_EQ(q->arm, Eigen::Vector2d(0.1, 0.2));
  EXPECT_EQ(q->drag, geom::Vec3(0.1, 0.2, 0));
  EXPECT_TRUE(a.gains);
  EXPECT_FALSE(quadrotor_of(parse(R"({"mass_kg":2,"thrust_n":[2,30]})")));
}

TEST(Airframe, OfAProfileThatIsFlownIsComplete) {
  for (const char* name : {"tello", "crazyflie", "quad2kg"}) {
    std::ifstream file(std::string(SKYWAY_SOURCE_DIR "/data/vehicles/") + name + ".json");
    std::stringstream text;
    text << file.rdbuf();
    const geom::JsonFields fields(text.str(), name, 0);
    EXPECT_TRUE(quadrotor_of(parse_airframe(fields))) << name;
  }
}

}  // namespace
}  // namespace traj
