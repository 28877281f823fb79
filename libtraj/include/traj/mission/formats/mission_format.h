#pragma once

// Formats of drones' files as values: what each is, how it is read and written, what it holds.
//
// Example:
//   const traj::MissionFormat table{
//       .format = {.word = "csv", .what = "a table", .readers = traj::kDroneReaders},
//       .has_legs = true};
//   assert(!table.write);  // it is not written

#include <iosfwd>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geom/base/format.h"
#include "geom/collision/collision.h"
#include "traj/mission/formats/file_option.h"
#include "traj/mission/formats/reading.h"
#include "traj/mission/formats/writing.h"

namespace traj {

// The tools that read most of them.
inline constexpr std::string_view kDroneReaders[] = {"skyway-check", "skyway-import-trajectory"};

// The heights that a file has on Earth: none, above the sea or the ellipsoid, or above home.
enum class FileHeights { none, absolute, above_home };

// A file and the verdict on its bytes. Where `result` is ok and `refusal` is not empty, something
// else than a check refused it.
struct MissionProof {
  WrittenMission written;
  CheckResult result;
  std::string refusal = {};
};

// All views refer to constants, and a format is one constant. A null function: the format does
// without it.
struct MissionFormat {
  geom::Format format;
  // Whether a whole text may be one, where no format's beginning tells: its reader says what is
  // wrong.
  bool (*may_be)(std::string_view text) = nullptr;

  // All flights of a text. Throws geom::InputError(source, …) for bad text and for what cannot be
  // flown or is not known, geom::UsageError where something of the task is missing. Null: it is not
  // read.
  ReadFlights (*read)(std::istream& in, const ReadTask& task) = nullptr;

  // The file of straight `legs` in ENU or, if `has_legs` is false, of the task's trajectory. Throws
  // geom::UsageError where the task lacks what the format needs. Null: it is not written.
  WrittenMission (*write)(const MissionTask& task, const geom::Polyline& legs) = nullptr;

  // Before a file of `legs` is written for the first time: what is tried first.
  void (*prepare)(MissionTask& task, const geom::Polyline& legs) = nullptr;
  // After a refusal: changes the task so that the next file may pass; false where nothing would
  // help.
  bool (*mend)(const WrittenMission& written, const CheckResult& result,
               MissionTask& task) = nullptr;
  // In place of reading the bytes again and judging what they make a vehicle fly.
  MissionProof (*prove)(const geom::CollisionScene& scene, const MissionTask& task) = nullptr;

  // Why the format cannot hold the flight; empty: it can.
  std::string (*unfit)(const ExportFlight& flight) = nullptr;
  // What the user of a file should know; `result` null: it was not checked.
  std::vector<std::string> (*warnings)(const MissionTask& task,
                                       const CheckResult* result) = nullptr;
  // What to do about a refusal; empty: what holds for every format.
  std::string (*remedy)(const MissionTask& task, const CheckResult& result) = nullptr;

  FileOptionSet reads_with = {};   // what may be said beside a file that is read
  FileOptionSet writes_with = {};  // and beside one that is written
  // m/s that the vehicle climbs and sinks at most, whatever speed along a leg the file asks for; 0:
  // not known. Null: 0.
  double (*climbs_at_most)(const ExportOptions& options) = nullptr;
  bool has_legs = false;  // straight legs, rather than the curve itself
  bool is_binary = false;
  bool is_flown = true;     // a vehicle takes it; else it is a table of paths
  bool says_when = false;   // the file has the instant at which the flight begins
  double rounding = 0.012;  // m by which the file's numbers, and vehicles, move a point at most
  FileHeights heights = FileHeights::none;
  double fastest = 0;                     // m/s along legs; 0: any
  std::string_view fastest_because = {};  // "at most 15 m/s, as DJI's missions take"
};

}  // namespace traj
