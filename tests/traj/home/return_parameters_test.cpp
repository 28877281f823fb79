#include "traj/home/return_parameters.h"

#include <gtest/gtest.h>

#include "support/reading.h"
#include "traj/mission/firmware/autopilot_settings.h"

namespace traj {
namespace {

AutopilotSettings read(const std::string& text) {
  return read_autopilot_settings(support::Text(text), "p");
}

TEST(ReturnParameters, ArePx4sOwn) {
  Autopilot pilot = px4("1.17");
  pilot.return_height = 72.5;
  const auto values = read(return_parameters(pilot, {})).values;
  EXPECT_EQ(values.at("RTL_RETURN_ALT"), 72.5);
  EXPECT_EQ(values.at("RTL_TYPE"), 0);
  EXPECT_EQ(values.at("RTL_CONE_ANG"), 45);
  EXPECT_EQ(values.at("NAV_DLL_ACT"), 2);
  EXPECT_EQ(values.at("NAV_RCL_ACT"), 2);
}

TEST(ReturnParameters, AreArdupilotsInCentimetresOrMetres) {
  Autopilot old = ardupilot("4.6");
  old.return_height = 72.5;
  EXPECT_EQ(read(return_parameters(old, {})).values.at("RTL_ALT"), 7250);
  Autopilot latest = ardupilot("4.7");
  latest.return_height = 72.5;
  const auto values = read(return_parameters(latest, {})).values;
  EXPECT_EQ(values.at("RTL_ALT_M"), 72.5);
  EXPECT_FALSE(values.contains("RTL_ALT"));
  EXPECT_EQ(values.at("FS_GCS_ENABLE"), 1);
}

TEST(ReturnParameters, TurnFencesOnWhereThereAreAny) {
  EXPECT_FALSE(read(return_parameters(ardupilot(), {})).values.contains("FENCE_ENABLE"));
  EXPECT_EQ(read(return_parameters(ardupilot(), {.fenced = true})).values.at("FENCE_ENABLE"), 1);
  EXPECT_EQ(read(return_parameters(ardupilot(), {.fenced = true})).values.at("FENCE_TYPE"), 4)
      << "its own would end 100 m above home";
  Autopilot low = ardupilot();
  low.fence.top = 50;
  EXPECT_EQ(read(return_parameters(low, {.fenced = true})).values.at("FENCE_TYPE"), 5);
}

TEST(HeightAsSet, IsAWholeCentimetreOfArdupilotAndNoLower) {
  EXPECT_EQ(height_as_set(px4(), 47.3333), 47.3333);
  EXPECT_EQ(height_as_set(ardupilot("4.7"), 47.3333), 47.3333);
  EXPECT_EQ(height_as_set(ardupilot("4.6"), 47.3333), 47.34);
  EXPECT_EQ(height_as_set(ardupilot("4.6"), 47.3), 47.3);
}

TEST(ReturnParameters, MakeALostLinkEndMissionsToo) {
  const auto has = [&](const char* version, const char* name) {
    return read(return_parameters(px4(version), {})).values.contains(name);
  };
  EXPECT_FALSE(has("1.11", "COM_RCL_EXCEPT"));
  EXPECT_TRUE(has("1.12", "COM_RCL_EXCEPT"));
  EXPECT_FALSE(has("1.16", "COM_DLL_EXCEPT"));
  EXPECT_TRUE(has("1.17", "COM_DLL_EXCEPT"));
  EXPECT_TRUE(has("", "COM_RCL_EXCEPT"));
}

}  // namespace
}  // namespace traj
