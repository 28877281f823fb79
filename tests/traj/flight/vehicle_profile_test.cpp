#include "traj/flight/vehicle_profile.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "support/reading.h"
#include "traj/scenes.h"

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
  EXPECT_TRUE(support::says(said(R"({"body":[1,1,1],"max_speed":3})"), "\"max_speed\""));
  EXPECT_TRUE(said("{}").starts_with("v.json: "));
  EXPECT_TRUE(support::says(said(R"({"body":[1,-1,1]})"), "body"));
  EXPECT_TRUE(support::says(said(R"({"body":[1,1,1],"tilt_max_deg":81})"), "tilt_max_deg"));
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

TEST(VehicleNamed, SaysHowFastItIsAndItsBoxHoldsItsBodyInEveryAttitude) {
  testing::Random random(36);
  for (const std::string_view name : vehicle_names()) {
    const VehicleProfile profile = *vehicle_named(name);
    EXPECT_EQ(profile.vehicle.name, name);
    EXPECT_TRUE(profile.vehicle.limits[geom::Limit::speed]) << name;
    const auto& tilt = profile.vehicle.limits[geom::Limit::tilt];
    ASSERT_TRUE(tilt) << name;
    for (int i = 0; i < 2000; ++i) {
      const double lean = i % 2 ? *tilt : random.number(0, *tilt);
      const double to = random.number(-M_PI, M_PI);
      const Eigen::AngleAxisd tilted(lean, geom::Vec3(std::cos(to), std::sin(to), 0));
      const Eigen::AngleAxisd turned(random.number(-M_PI, M_PI), geom::Vec3::UnitZ());
      const auto sign = [&] { return random.number(-1, 1) < 0 ? -1.0 : 1.0; };
      const geom::Vec3 corner = profile.body->cwiseProduct(geom::Vec3(sign(), sign(), sign()));
      const geom::Vec3 reach = (tilted * (turned * corner)).cwiseAbs();
      EXPECT_LE((reach - profile.vehicle.half).maxCoeff(), 0) << name;
    }
  }
}

nlohmann::json json_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return nlohmann::json::parse(text.str());
}

// The keys that a member of "sources" is about: "limits, tilt_max_deg".
std::set<std::string> sourced(const nlohmann::json& profile) {
  std::set<std::string> keys;
  for (const auto& [text, source] : profile.at("sources").items()) {
    EXPECT_FALSE(source.get<std::string>().empty()) << text;
    std::istringstream words(text);
    for (std::string word; words >> word;) keys.insert(word.substr(0, word.find(',')));
  }
  return keys;
}

TEST(VehicleNamed, IsAFileOfDataByEachOfItsNamesWithASourceForEachFigure) {
  std::set<std::string> names;
  for (const auto& entry :
       std::filesystem::directory_iterator(SKYWAY_SOURCE_DIR "/data/vehicles")) {
    const nlohmann::json profile = json_of(entry.path());
    const std::string name = entry.path().stem();
    EXPECT_EQ(profile.at("name"), name);
    std::set<std::string> keys;
    for (const auto& [key, value] : profile.items()) keys.insert(key);
    keys.erase("name");
    keys.erase("sources");
    EXPECT_EQ(sourced(profile), keys) << name;
    ASSERT_TRUE(names.insert(name).second) << name;
    for (const std::string also : profile.value("also", nlohmann::json::array())) {
      ASSERT_TRUE(names.insert(also).second) << also << " is known already";
      ASSERT_TRUE(vehicle_named(also)) << also;
      geom::Vehicle same = vehicle_named(also)->vehicle;
      same.name = name;
      EXPECT_EQ(same, vehicle_named(name)->vehicle) << also;
    }
  }
  const auto known = vehicle_names();
  EXPECT_EQ(names, std::set<std::string>(known.begin(), known.end()));
}

}  // namespace
}  // namespace traj
