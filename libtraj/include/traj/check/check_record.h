#pragma once

// The proof of a record, as a report: what skyway-check says of a trajectory, a path or a file.
//
// Example:
//   const geom::PathRecord record{.id = "q1", .status = geom::PathStatus::found, .points = path};
//   const traj::ReportRecord report = traj::check_record(scene, record, {}, "paths.jsonl", 1);
//   assert(traj::accepted(report));
//   std::cout << traj::to_json_line(report, map);

#include <optional>
#include <string>
#include <string_view>

#include "geom/collision/collision.h"
#include "geom/record/record.h"
#include "traj/mission/read_mission.h"
#include "traj/record/report_record.h"
#include "traj/record/trajectory_record.h"

namespace traj {

// How strictly records are held.
struct RecordRules {
  Limits asked = {};                      // by the run
  std::optional<Limits> of_vehicle = {};  // in place of those of the scene's vehicle
  bool override_record = false;           // `asked` may be looser than what a record carries
  bool exact = false;                     // check once more in exact numbers
  bool exact_if_straight = false;         // of drone files: only those of straight legs alone
  bool stands = false;                    // on its pads before and after, where boxes have times
  Clearance clearance = Clearance::measured;  // in the report
};

// The report of a record over the scene that was made for it. The strictest of the limits of the
// run, the record and the vehicle hold. A record that gives no way to measure a limit of the run is
// refused. A limit that only the vehicle has, and that no path or mission commands, is left to the
// vehicle. A record that holds nothing to check has an unsolved_report(). Throws
// InputError(source, line, …) if the record is of another epoch than the map, and UsageError as
// geom::limits_to_check() does.
ReportRecord check_record(const geom::CollisionScene& scene, const TrajectoryRecord& record,
                          const RecordRules& rules, std::string_view source, std::size_t line);
ReportRecord check_record(const geom::CollisionScene& scene, const geom::PathRecord& record,
                          const RecordRules& rules, std::string_view source, std::size_t line);

// The report of what a vehicle flies when it gets a file; `flier` is the one that the file was read
// for. Throws UsageError if `rules.exact` is set, `rules.exact_if_straight` is not, and the file is
// not of straight legs alone.
ReportRecord check_record(const geom::CollisionScene& scene, const FileFlight& file,
                          const Flier& flier, const RecordRules& rules);

// The report of a record that holds nothing to check: the reason is that of its status. Not for a
// solved trajectory or a found path.
ReportRecord unsolved_report(const TrajectoryRecord& record);
ReportRecord unsolved_report(const geom::PathRecord& record);

// How the corners of a mission were taken, for a warning. Empty if it has none.
std::string corner_note(const Flown& flown);

}  // namespace traj
