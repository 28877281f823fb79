#include "traj/mission/dji/dji_wpml.h"

#include <gtest/gtest.h>

#include <sstream>

#include "geom/archive/small_zip.h"
#include "support/reading.h"
#include "traj/mission/dji/dji_examples.h"
#include "traj/mission/mavlink/examples.h"

namespace traj {
namespace {

using testing::dji_config;
using testing::dji_folder;
using testing::dji_leg;
using testing::dji_takeoff;
using testing::in_kml;
using testing::kFrame;
using testing::kPoints;

std::string kmz_of(const DjiMission& mission) {
  std::ostringstream out;
  write_dji_kmz(out, mission, "skyway & co");
  return out.str();
}

std::string zipped(const std::vector<geom::SmallFile>& files) {
  std::ostringstream out;
  geom::write_small_zip(out, files);
  return out.str();
}

DjiMission read(const std::string& kmz) { return read_dji_kmz(support::Text(kmz), "m.kmz"); }

std::string refusal(const std::string& kmz) {
  return support::refusal_of([&] { read(kmz); });
}

void expect_same(const DjiMission& back, const DjiMission& mission) {
  EXPECT_EQ(back.version, mission.version);
  EXPECT_EQ(back.aircraft, mission.aircraft);
  EXPECT_EQ(back.approach, mission.approach);
  EXPECT_EQ(back.finish, mission.finish);
  EXPECT_EQ(back.security_height, mission.security_height);
  EXPECT_EQ(back.transit_speed, mission.transit_speed);
  EXPECT_EQ(back.takeoff, mission.takeoff);
  ASSERT_EQ(back.waylines.size(), 1u);
  const auto& a = back.waylines[0].waypoints;
  const auto& b = mission.waylines[0].waypoints;
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].latitude, b[i].latitude) << i;
    EXPECT_EQ(a[i].longitude, b[i].longitude) << i;
    EXPECT_EQ(a[i].height, b[i].height) << i;
    EXPECT_EQ(a[i].speed, b[i].speed) << i;
    EXPECT_EQ(a[i].hover, 0) << i;
    EXPECT_EQ(a[i].turn, b[i].turn) << i;
    EXPECT_EQ(a[i].damping, b[i].damping) << i;
  }
}

TEST(DjiKmz, ReadsBackWhatWasWritten) {
  for (const char* version : {"1.0.2", "1.0.6"}) {
    DjiOptions options;
    options.home = 2.5;
    options.speed = 3.3;
    options.version = version;
    options.aircraft = {67, 1};
    options.lands = version[4] == '2';
    if (options.lands) options.turns = {7.25, 7.25, 7.25};
    const DjiMission mission = make_dji_mission(kPoints, kFrame, options);
    const std::string kmz = kmz_of(mission);
    EXPECT_EQ(kmz, kmz_of(mission)) << "the same bytes";
    expect_same(read(kmz), mission);
  }
}

TEST(DjiKmz, SaysWhatALostLinkTheGimbalAndTheNoseDo) {
  for (const auto& [lost_link, word] : kDjiLostLinkWords) {
    DjiOptions options;
    options.lost_link = lost_link;
    const DjiMission mission = make_dji_mission(kPoints, kFrame, options);
    EXPECT_EQ(read(kmz_of(mission)).without_link, mission.without_link) << word;
    EXPECT_EQ(read(kmz_of(mission)).actions, 0u);
  }
  DjiOptions options;
  options.gimbal = -90;
  options.nose = 270;
  options.aircraft = {67, 1};
  const std::string kmz = kmz_of(make_dji_mission(kPoints, kFrame, options));
  EXPECT_EQ(read(kmz).actions, 1u) << "at the first waypoint alone";
  for (const char* text :
       {"<wpml:gimbalPitchRotateAngle>-90<", "<wpml:payloadEnumValue>53<",
        "<wpml:waypointHeadingAngle>-90<", "<wpml:exitOnRCLost>executeLostAction<",
        "<wpml:executeRCLostAction>goBack<"}) {
    const std::size_t first = kmz.find(text);
    ASSERT_NE(first, std::string::npos) << text;
    EXPECT_NE(kmz.find(text, first + 1), std::string::npos) << text << " in the other file, too";
  }
}

TEST(DjiKmz, HoldsTheTwoFilesOfWpml) {
  const std::string kmz = kmz_of(make_dji_mission(kPoints, kFrame, {}));
  const auto files =
      geom::files_of_zip(kmz, "m", {"a mission", {"wpmz/template.kml", "wpmz/waylines.wpml"}, {}});
  ASSERT_EQ(files.size(), 2u);
  EXPECT_TRUE(support::says(files[0].content, "<wpml:author>skyway &amp; co</wpml:author>"));
}

TEST(DjiKmz, WhatIsNoKmzOfDjiIsRefused) {
  EXPECT_EQ(refusal("<kml/>"),
            "m.kmz: expected a mission of DJI (.kmz) (a ZIP archive), found a "
            "file that begins with \"<kml/>\"");
  const std::string waylines = in_kml(dji_config() + dji_folder(dji_leg()));
  EXPECT_EQ(refusal(zipped({{"wpmz/a.jpg", waylines}})),
            "m.kmz: expected wpmz/waylines.wpml, which a DJI aircraft flies, found none");
  EXPECT_EQ(refusal(zipped({{"wpmz/waylines.wpml", waylines}, {"waylines.wpml", waylines}})),
            "m.kmz: waylines.wpml: expected no other file that ends in .wpml than "
            "wpmz/waylines.wpml and wpmz/template.kml");
  EXPECT_EQ(refusal(zipped({{"wpmz/template.kml", waylines}})),
            "m.kmz: expected wpmz/waylines.wpml, which a DJI aircraft flies, found none");
  EXPECT_EQ(refusal(zipped({{"wpmz/waylines.wpml", waylines}})), "") << "without a template";
  EXPECT_EQ(
      refusal(zipped({{"wpmz/waylines.wpml", in_kml("", "2")}})),
      "m.kmz/wpmz/waylines.wpml:2: expected WPML of version 1.0.0 or 1.0.2 to 1.0.6, found 2");
  EXPECT_EQ(refusal(zipped({{"wpmz/waylines.wpml", waylines}, {"wpmz/template.kml", "<kml>"}})),
            "m.kmz/wpmz/template.kml:1: the element of line 1 is not ended: the file may be cut");
  EXPECT_EQ(refusal(zipped({{"wpmz/waylines.wpml", waylines.substr(0, 400)}}))
                .find("m.kmz/wpmz/waylines.wpml:"),
            0u);
}

TEST(DjiWpml, IsHeldAgainstItsTemplate) {
  const std::string waylines = in_kml(dji_config() + dji_folder(dji_leg()));
  EXPECT_FALSE(read_dji_wpml(waylines, "", "m").takeoff);
  EXPECT_TRUE(read_dji_wpml(waylines, in_kml(dji_config(dji_takeoff())), "m").takeoff);
  EXPECT_NE(support::refusal_of(
                [&] { read_dji_wpml(waylines, in_kml(dji_config("", "autoLand")), "m"); }),
            "");
}

}  // namespace
}  // namespace traj
