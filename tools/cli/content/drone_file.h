#pragma once

// Options of tools that read drone files, and the files as what they make a vehicle fly over a map.

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "cli/content/terrain_option.h"
#include "cli/file/files.h"
#include "cli/option/autopilot_option.h"
#include "cli/option/format_options.h"
#include "traj/mission/read_mission.h"

namespace cli {

// The word of --format and --file-format for what is found out from the beginning of a file.
inline constexpr const char* kAuto = "auto";
// Of --file-format: a flight log, which is no drone file.
inline constexpr const char* kFlightLogWord = "flight-log";

// Of --file-format: streams of trajectories and paths.
inline constexpr const char* kRecordsWord = "records";

struct DroneFileOptions {
  std::string format = {};  // a word of traj::mission_formats() or kAuto; empty: records
  traj::MissionReading reading = {};
  TerrainOption terrain = {};
  AutopilotOptions autopilot = {};
  // Where it is set, read_drone_file() refuses what the format of the file does not use.
  const CLI::App* app = nullptr;

  bool is_flight_log() const { return format == kFlightLogWord; }

  // --file-format, --paths-csv, --start, those of the placement and all of missions; sets `app`.
  void add_to(CLI::App& parser);
  void add_mission_to(CLI::App& app);  // all of missions
  // --return-height, --terrain-height, --ground-model and --terrain-error of missions.
  void add_heights_to(CLI::App& app);

  // Where the options say no format, or auto: finds out by the beginning of `file`, which stays to
  // be read, whether it is records, a flight log or a drone file, and sets `format`. A file that
  // begins as none of these is left to the reader of records, or to auto, which refuse it.
  void settle(InputFile& file);

  // Reads the ground of --ground-model for the rules of reading, which then point into this. Throws
  // UsageError where an option of it lacks the other, InputError where it is that of another map.
  void settle_ground(const geom::Frame& frame);

  // Throws UsageError for an option of the app that this format does not use (format_options.h):
  // one of drone files, "records" or "flight-log".
  void require_used(std::string_view of_format, std::string_view because) const;
  // Throws UsageError for a height, ground or terrain that no flight of the file uses.
  void require_used(std::span<const traj::FileFlight> flights, const std::string& source) const;
  // The same for all options of `parser`, if neither these flights of any files nor records or
  // flight logs use them.
  void require_any_used(const CLI::App& parser, std::span<const traj::FileFlight> flights) const;
};

// kAuto, and the words of the formats that a tool of this name reads.
std::vector<std::string> drone_file_words(std::string_view tool);

// Which formats use which option when they are read or written, for require_used().
std::vector<FormatOption> file_option_rows(traj::FileOptionSet traj::MissionFormat::*used);

// traj::read_mission of a file's text, in the format that the options name or that it begins as.
// Throws UsageError for options that this does not use.
std::vector<traj::FileFlight> read_drone_file(const std::string& text, const std::string& source,
                                              const DroneFileOptions& options,
                                              const geom::Frame& frame);

}  // namespace cli
