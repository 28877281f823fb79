#pragma once

// The table of drone files' formats.
//
// Example:
//   const traj::MissionFormat* const wpl = traj::mission_format_named("wpl");
//   assert(wpl && wpl->has_legs && !traj::mission_format_named("doc"));

#include <span>
#include <string_view>
#include <vector>

#include "traj/mission/formats/mission_format.h"

namespace traj {

// Each is defined in the file of its name in src/mission/formats.
extern const MissionFormat kCrazyflie;
extern const MissionFormat kSetpoints;
extern const MissionFormat kTello;
extern const MissionFormat kWpl;
extern const MissionFormat kQgcPlan;
extern const MissionFormat kDjiWpml;
extern const MissionFormat kKml;
extern const MissionFormat kGeojson;
extern const MissionFormat kGltfLine;
extern const MissionFormat kPathsCsv;
extern const MissionFormat kVolume4d;

// In the order in which options and messages list them.
inline constexpr const MissionFormat* kMissionFormats[] = {
    &kCrazyflie, &kSetpoints, &kTello,    &kWpl,      &kQgcPlan, &kDjiWpml,
    &kKml,       &kGeojson,   &kGltfLine, &kPathsCsv, &kVolume4d};
inline std::span<const MissionFormat* const> mission_formats() { return kMissionFormats; }

// The format of this word; null where there is none.
const MissionFormat* mission_format_named(std::string_view word);

// What a whole text is, by its beginning; of one that nobody knows, the format whose reader says
// best what is wrong with it. A hint: only the reader knows.
const MissionFormat& recognised_mission_format(std::string_view text);

// The words of those that a tool of this name reads, and of those that are written.
std::vector<std::string_view> mission_words_of(std::string_view reader);
std::vector<std::string_view> written_mission_words();

}  // namespace traj
