#include "traj/flight/gains.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "flight/airframe_record.h"
#include "geom/text/json_fields.h"
#include "support/reading.h"
#include "traj/flight/airframe.h"
#include "traj/flight/gains_record.h"

namespace traj {
namespace {

Airframe parse(const std::string& json) {
  return parse_airframe(geom::JsonFields(json, "v.json", 0));
}

std::string refusal(const std::string& json) {
  return support::refusal_of([&] { parse(json); });
}

constexpr const char* kWhole =
    R"("mass_kg":2,"inertia_kg_m2":[1,2,3],"thrust_n":[2,30],"motor_time_constant_s":0.1,)"
    R"("motor_arm_m":[0.1,0.2],"torque_per_thrust_m":0.02)";

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
  EXPECT_TRUE(support::says(with("3"), "gains must be an object, found 3"));
  EXPECT_TRUE(support::says(with(R"({"attitude":[1,-1,1]})"), "gains.attitude must be >= 0"));
  EXPECT_TRUE(
      support::says(with(R"({"position":{"clip":0}})"), "gains.position.clip must be from"));
  EXPECT_TRUE(support::says(with(R"({"positoin":{}})"), "gains has no key \"positoin\""));
  EXPECT_TRUE(support::says(with(R"({"rates":{"p":[1,2]}})"), "gains.rates.p"));
  EXPECT_TRUE(support::says(refusal(R"({"gains":{}})"), "gains need mass_kg"));
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

// With the motors' lag T, a rate w under p and d obeys T w'' + (1 + d) w' + p w = p wanted.
TEST(NominalGains, DampTheRatesAndLeaveOuterLoopsSlower) {
  Quadrotor q;
  for (const double lag : {0.01, 0.05, 0.2}) {
    q.motor_time_constant = lag;
    const Gains gains = nominal_gains(q, 0.4);
    for (int k = 0; k < 3; ++k) {
      const double p = gains.rates.p[k];
      EXPECT_NEAR((1 + gains.rates.d[k]) / (2 * std::sqrt(lag * p)), 0.8, 1e-12) << "axis " << k;
      EXPECT_EQ(1 + gains.rates.d[k], k == 2 ? 1 : 3) << "axis " << k;
      EXPECT_NEAR(gains.attitude[k], std::sqrt(p / lag) / 4, 1e-9) << "axis " << k;
      EXPECT_LT(gains.position.p[k], gains.velocity.p[k]) << "axis " << k;
    }
    EXPECT_NEAR(gains.velocity.p.x(), gains.attitude.x() / 4, 1e-12);
    EXPECT_EQ(gains.tilt_max, 0.4);
  }
}

}  // namespace
}  // namespace traj
