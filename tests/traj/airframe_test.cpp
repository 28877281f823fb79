#include "traj/airframe.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "geom/error.h"
#include "traj/io/airframe_record.h"

namespace traj {
namespace {

Airframe parse(const std::string& json) {
  return parse_airframe(geom::JsonFields(json, "v.json", 0));
}

std::string refusal(const std::string& json) {
  try {
    parse(json);
  } catch (const geom::InputError& error) {
    return error.what();
  }
  return "";
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

TEST(Airframe, OfEveryProfileInDataIsReadAndHasSources) {
  for (const char* name : {"tello", "crazyflie", "quad2kg"}) {
    std::ifstream file(std::string(SKYWAY_SOURCE_DIR "/data/vehicles/") + name + ".json");
    std::stringstream text;
    text << file.rdbuf();
    const geom::JsonFields fields(text.str(), name, 0);
    EXPECT_TRUE(parse_airframe(fields).mass) << name;
    EXPECT_TRUE(fields.has("sources")) << name;
  }
}

}  // namespace
}  // namespace traj
