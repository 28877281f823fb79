#include <gtest/gtest.h>

#include "support/reading.h"
#include "traj/flight/vehicle_profile.h"

namespace traj {
namespace {

using support::says;

std::string profile(const std::string& members) { return R"({"body":[1,1,1],)" + members + "}"; }

Energy energy(const std::string& members) {
  return *parse_vehicle_profile(profile(members), "v.json").energy;
}

std::string refused(const std::string& members) {
  return support::refusal_of([&] { parse_vehicle_profile(profile(members), "v.json"); });
}

TEST(Energy, IsAbsentUnlessTheProfileSaysSo) {
  EXPECT_FALSE(parse_vehicle_profile(profile(R"("battery_wh":74,"endurance_s":1200)"), "v").energy);
}

TEST(Energy, TakesBatteryAndHoverPowerOfTheProfile) {
  const Energy e = energy(R"("battery_wh":74,"endurance_s":1200,"energy":{})");
  EXPECT_DOUBLE_EQ(e.capacity, 74 * 3600);
  EXPECT_DOUBLE_EQ(e.power, 222);
  EXPECT_EQ(e.reserve, 0.2);
  EXPECT_EQ(e.wind, 0);
  EXPECT_DOUBLE_EQ(flying_time(e), 960);
}

TEST(Energy, ABatteryThatHoldsLessLastsLess) {
  const Energy e = energy(R"("battery_wh":74,"endurance_s":1200,"energy":{"capacity_wh":37})");
  EXPECT_DOUBLE_EQ(e.power, 222);
  EXPECT_DOUBLE_EQ(flying_time(e), 480);
}

TEST(Energy, CountsTheLargestPower) {
  const Energy e =
      energy(R"("energy":{"capacity_wh":10,"hover_w":100,"cruise_w":90,"climb_w":150,"reserve":0,)"
             R"("wind_m_s":3})");
  EXPECT_EQ(e.power, 150);
  EXPECT_EQ(e.wind, 3);
  EXPECT_DOUBLE_EQ(flying_time(e), 240);
}

TEST(Energy, RefusesWhatCannotBe) {
  EXPECT_TRUE(says(refused(R"("battery_wh":0,"energy":{"hover_w":1})"), "battery_wh"));
  EXPECT_TRUE(says(refused(R"("energy":{"capacity_wh":0,"hover_w":1})"), "energy.capacity_wh"));
  EXPECT_TRUE(says(refused(R"("energy":{"hover_w":1})"), "capacity_wh"));
  EXPECT_TRUE(says(refused(R"("battery_wh":9,"energy":{})"), "hover_w"));
  EXPECT_TRUE(says(refused(R"("battery_wh":9,"energy":{"hover_w":1,"reserve":1})"), "reserve"));
  EXPECT_TRUE(says(refused(R"("battery_wh":9,"energy":{"hover_w":1,"wind_m_s":-1})"), "wind_m_s"));
  EXPECT_TRUE(says(refused(R"("battery_wh":9,"energy":{"hover_w":1,"wind":1})"), "\"wind\""));
  EXPECT_TRUE(says(refused(R"("battery_wh":9,"energy":4)"), "an object"));
}

}  // namespace
}  // namespace traj
