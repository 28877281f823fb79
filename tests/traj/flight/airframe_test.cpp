#include "traj/flight/airframe.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "geom/base/error.h"
#include "geom/text/json_fields.h"
#include "support/refusal.h"
#include "traj/record/airframe_record.h"
#include "traj/record/gains_record.h"

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
  EXPECT_NE(refusal(R"({"mass_kg":0})").find("mass_kg must be > 0, found 0"), std::string::npos);
  EXPECT_NE(refusal(R"({"mass_kg":"2"})").find("mass_kg must be a finite number"),
            std::string::npos);
  EXPECT_NE(refusal(R"({"inertia_kg_m2":[1,1,3]})").find("at most the sum of the other two"),
            std::string::npos);
  EXPECT_NE(refusal(R"({"thrust_n":[3,2]})").find("0 <= least < most, found [3,2]"),
            std::string::npos);
  EXPECT_NE(refusal(R"({"mass_kg":2,"thrust_n":[0,19]})").find("more than the weight, 19.61 N"),
            std::string::npos);
  EXPECT_NE(refusal(R"({"body_rate_max_rad_s":[1,-1,1]})").find("> 0 about each axis"),
            std::string::npos);
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

TEST(Gains, StandOverThoseThatFollowFromTheMotors) {
  const Airframe plain = parse(std::string("{") + kWhole + "}");
  const Airframe a = parse(
      std::string("{") + kWhole +
      R"(,"gains":{"position":{"p":[1,2,3],"clip":4},"tilt_max_deg":20,"feed_forward":{"velocity":0}}})");
  EXPECT_EQ(a.gains->position.p, geom::Vec3(1, 2, 3));
  EXPECT_EQ(a.gains->position.clip, 4);
  EXPECT_NEAR(a.gains->tilt_max, 0.349066, 1e-6);
  EXPECT_EQ(a.gains->feed_forward.velocity, 0);
  EXPECT_EQ(a.gains->feed_forward.acceleration, 1);
  EXPECT_EQ(a.gains->velocity.p, plain.gains->velocity.p);
}

TEST(Gains, ComeBackAsTheyWereWritten) {
  Gains gains = *parse(std::string("{") + kWhole + "}").gains;
  gains.velocity.clip = 5;
  gains.geometric.lead = {0.1, 0.2, 0.3};
  const std::string text = to_json(gains);
  EXPECT_EQ(to_json(parse_gains(geom::JsonFields(text, "g.json", 0), Gains{})), text);
}

TEST(Gains, AreRefusedWhereTheyCannotBe) {
  const auto with = [](const char* gains) {
    return refusal(std::string("{") + kWhole + R"(,"gains":)" + gains + "}");
  };
  EXPECT_NE(with("3").find("gains must be an object, found 3"), std::string::npos);
  EXPECT_NE(with(R"({"attitude":[1,-1,1]})").find("gains.attitude must be >= 0"),
            std::string::npos);
  EXPECT_NE(with(R"({"position":{"clip":0}})").find("gains.position.clip must be from"),
            std::string::npos);
  EXPECT_NE(with(R"({"positoin":{}})").find("gains has no key \"positoin\""), std::string::npos);
  EXPECT_NE(with(R"({"rates":{"p":[1,2]}})").find("gains.rates.p"), std::string::npos);
  EXPECT_NE(refusal(R"({"gains":{}})").find("gains need mass_kg"), std::string::npos);
}

TEST(Gains, OfPresetsAreTheirTables) {
  const Gains own = *parse(std::string("{") + kWhole + "}").gains;
  const auto a = preset_gains("stack-a", own);
  ASSERT_TRUE(a);
  EXPECT_EQ(a->position.d, geom::Vec3(0.4, 0.4, 0.45));
  EXPECT_EQ(a->velocity.clip, 5);
  EXPECT_EQ(a->feed_forward.velocity, 0);
  EXPECT_EQ(a->rates.p, own.rates.p);
  const auto b = preset_gains("stack-b", own);
  ASSERT_TRUE(b);
  EXPECT_EQ(b->velocity.p, geom::Vec3(2, 2, 20));
  EXPECT_FALSE(preset_gains("stack-c", own));
}

TEST(Airframe, OfEveryProfileInDataIsReadAndHasSources) {
  for (const char* name : {"tello", "crazyflie", "quad2kg"}) {
    std::ifstream file(std::string(SKYWAY_SOURCE_DIR "/data/vehicles/") + name + ".json");
    std::stringstream text;
    text << file.rdbuf();
    const geom::JsonFields fields(text.str(), name, 0);
    EXPECT_TRUE(quadrotor_of(parse_airframe(fields))) << name;
    // Each figure has its source.
    const std::string sources = fields.value("sources").dump();
    for (const auto& [key, value] : fields.object().items()) {
      if (key == "name" || key == "sources") continue;
      EXPECT_NE(sources.find(key), std::string::npos) << name << ": " << key;
    }
  }
}

}  // namespace
}  // namespace traj
