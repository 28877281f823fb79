#include "traj/mission/formats/mission_formats.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace traj {
namespace {

TEST(MissionFormats, HaveWordsOfTheirOwnAndAreReadOrWritten) {
  std::set<std::string> words;
  for (const MissionFormat* one : mission_formats()) {
    const std::string word(one->format.word);
    EXPECT_FALSE(one->format.what.empty()) << word;
    EXPECT_TRUE(words.insert(word).second) << word;
    EXPECT_TRUE(one->read || one->write || one->prove) << word;
    EXPECT_EQ(one->read != nullptr, !one->format.readers.empty()) << word;
    EXPECT_EQ(mission_format_named(word), one);
    EXPECT_EQ(one->fastest > 0, !one->fastest_because.empty()) << word;
  }
  EXPECT_EQ(mission_format_named("auto"), nullptr);
  EXPECT_EQ(mission_format_named(""), nullptr);
}

// An option that no format uses would be refused beside every file.
TEST(MissionFormats, UseEveryOptionSomewhere) {
  for (const auto& [option, word] : kFileOptionWords) {
    const auto all = mission_formats();
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const MissionFormat* one) {
      return one->reads_with.has(option) || one->writes_with.has(option);
    })) << word;
  }
}

TEST(MissionFormats, AreListedForTheirToolsInOneOrder) {
  const std::vector<std::string_view> written = written_mission_words();
  EXPECT_EQ(written,
            (std::vector<std::string_view>{"crazyflie", "setpoints", "tello", "wpl", "qgc-plan",
                                           "dji-wpml", "kml", "geojson", "gltf", "volume4d"}));
  const std::vector<std::string_view> read = mission_words_of("skyway-check");
  EXPECT_EQ(read.back(), "paths-csv");
  EXPECT_TRUE(std::equal(read.begin(), read.end() - 1, written.begin()));
  const std::vector<std::string_view> imported = mission_words_of("skyway-import-trajectory");
  EXPECT_EQ(std::count(imported.begin(), imported.end(), "setpoints"), 0);
  EXPECT_EQ(imported.size() + 1, read.size());
  EXPECT_TRUE(mission_words_of("skyway-plan-b").empty());
}

TEST(RecognisedMissionFormat, GoesByTheFirstThingInTheText) {
  const auto word = [](std::string_view text) {
    return std::string(recognised_mission_format(text).format.word);
  };
  EXPECT_EQ(word("QGC WPL 110\n"), "wpl");
  EXPECT_EQ(word("\xef\xbb\xbf \r\nQGC WPL 110\n"), "wpl");
  EXPECT_EQ(word(R"({"fileType": "Plan", "coordinates": []})"), "qgc-plan");
  EXPECT_EQ(word(R"({"type": "LineString", "coordinates": []})"), "geojson");
  EXPECT_EQ(word("glTF\2"), "gltf");
  EXPECT_EQ(word("PK\3\4 wpmz/template.kml"), "dji-wpml");
  EXPECT_EQ(word("<?xml version=\"1.0\"?>\n<kml>"), "kml");
  EXPECT_EQ(word("command\ntakeoff\n"), "tello");
  EXPECT_EQ(word("Duration,x^0,"), "crazyflie");
  EXPECT_EQ(word("t_s,east_m,"), "setpoints");
  EXPECT_EQ(word("id,x,y,z\n"), "paths-csv");
}

// So that its reader says what is wrong.
TEST(RecognisedMissionFormat, TakesWhatNobodyKnowsForTheLikeliest) {
  EXPECT_EQ(&recognised_mission_format(R"({"type": "Feature"})"), &kQgcPlan);
  EXPECT_EQ(recognised_mission_format("<gpx>").format.word, "kml");
  EXPECT_EQ(recognised_mission_format("PK\3\4").format.word, "dji-wpml");
  EXPECT_EQ(&recognised_mission_format("name;lat;lon\n"), &kPathsCsv);
  EXPECT_EQ(&recognised_mission_format(""), &kPathsCsv);
}

}  // namespace
}  // namespace traj
