#pragma once

// Reports of the check, as JSON Lines records.
//
// Example:
//   traj::ReportRecord report{.id = "q1", .checked = "trajectory"};
//   report.result = traj::check(scene, trajectory, limits);
//   report.provenance = geom::provenance_of(scene);
//   report.limits = limits;
//   const std::string line = traj::to_json_line(report, map);
//   assert(traj::parse_report_record(line, "report.jsonl", 1).ok);

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geom/base/error.h"
#include "geom/map/box_map.h"
#include "geom/record/record.h"
#include "traj/flight/flight_log.h"
#include "traj/flight/flown_path.h"
#include "traj/proof/check.h"
#include "traj/proof/exact/exact_check.h"
#include "traj/record/return_report.h"
#include "traj/record/return_summary.h"
#include "traj/record/terrain_claim.h"
#include "traj/record/trajectory_record.h"
#include "traj/record/tube_record.h"

namespace traj {

// The tube of a flight, held against the map.
struct TubeReport {
  TubeClaim claim;
  FlightPathCheck check;
  double margin = 0;  // m around the vehicle and its tube
};

// `checked` of the ways home of a flight (traj/home/check_contingencies.h).
inline constexpr std::string_view kCheckedContingency = "contingency";

// `checked` of a flight log (traj/record/sampled_report.h).
inline constexpr std::string_view kCheckedFlightLog = "flight log";

// `reason` where the way is clear, and not with the tube around it.
inline constexpr std::string_view kTubeReason = "tube";

struct ReportRecord {
  std::string id;
  std::string checked;  // "trajectory", "path" or kCheckedContingency
  CheckResult result;   // a record that holds nothing to check has only `reason`
  geom::Provenance provenance;
  Limits limits;                        // those it was held to
  std::optional<ExactResult> exact;     // where it was asked for
  std::vector<std::string> overridden;  // limits, and "vehicle" for its room, that were loosened
  // Of a trajectory: what its record claims of the length of paths, which no check here verifies,
  // and the seconds that follow for any flight within `limits` (duration_bound.h).
  std::optional<double> claimed_bound = {};
  std::optional<double> duration_bound = {};
  // Of a mission: home as it was assumed, and how many items move nothing.
  std::optional<Vec3> home = {};
  std::size_t idle_items = 0;
  // Of a drone file: the autopilots for which the result holds, their assumed parameters, the
  // airframe's drag over its mass (1/s), and metres across and up or down by which the vehicle may
  // be wrong about its place, or stray.
  std::string autopilot = {};
  std::vector<std::string> assumed = {};
  std::optional<double> drag = {};
  std::optional<std::array<double, 2>> navigation = {};
  std::optional<std::array<double, 2>> tracking = {};
  std::size_t endless_jumps = 0;
  std::optional<TerrainClaim> terrain = {};  // of a mission with heights above terrain
  std::string detail = {};                   // of the reason, in words; may be empty
  geom::FlightTime time = {};
  // Whether timed boxes counted by their times; else as always there.
  bool by_time = false;
  std::optional<ReturnReport> returns = {};  // where it was asked for
  std::optional<TubeReport> tube = {};       // likewise
  bool dropped = false;  // refused and left out: the verdict on the others does not count it
  // checked_hash() of what was checked, or of the flight whose ways home were; empty: of a drone
  // file or of nothing.
  std::string checked_hash = {};
};

// Adds to `report`, the result for `record`, its bounds. Refuses an accepted record
// that claims too much. A bound of another map, vehicle or margin, or of none, is left out.
void add_bounds(const TrajectoryRecord& record, ReportRecord& report);

// Refuses an accepted path that is shorter than its own bound.
void add_bounds(const geom::PathRecord& record, ReportRecord& report);

// Refuses an accepted record if a limit was asked for and not measured; the place is its first.
void refuse_unmeasured(const Limits& asked, const Vec3& place, ReportRecord& report);

// Whether every check that was made accepts the record.
bool accepted(const ReportRecord& record);

// Ends with a newline. `map` gives the source id of the obstacle that was hit.
std::string to_json_line(const ReportRecord& record, const geom::BoxMap& map);

// A report of skyway-check or skyway-fly, as it reads without the map.
struct ReportSummary {
  struct Named {
    std::string name;  // as in the record: "clearance", "speed", "acceleration", "rms", …
    double value = 0;
    std::optional<double> time;  // seconds
  };

  std::string id;
  std::string checked;       // "trajectory", "path", "flight log" or "flight"; may be empty
  std::string checked_hash;  // checked_hash() of that; empty: the report does not say it
  bool ok = false;
  std::string reason;  // empty when ok
  std::optional<double> time;
  std::optional<Vec3> place;
  std::optional<double> worst;
  std::optional<std::uint64_t> box;   // its id in the source
  std::optional<std::uint64_t> item;  // of a mission, as its file counts
  std::string part;                   // of a mission: the manoeuvre; may be empty
  std::string detail;                 // may be empty
  std::optional<double> duration;
  std::optional<double> duration_bound;  // seconds
  std::vector<Named> extremes;           // of what was measured
  std::optional<bool> exact_ok;          // where the exact check was asked for
  std::optional<ReturnSummary> returns;  // where it was asked for
  geom::Provenance provenance;
  Limits limits;
  // What an accepted one rests on or leaves out, in words, as rests_on_in_words (verdict.h) says
  // it; may be empty.
  std::string rests_on;
  bool overridden = false;  // something was looser than its record says
  geom::FlightTime start;
  bool by_time = false;  // timed boxes counted by their times, so it holds for this start alone
};

// Why a report is of another trajectory, path or log than this one with its id: its numbers differ,
// or its start does where that counts. Nothing if no difference is known, and for a report of
// another kind. A report without a hash may be of any path, any log, and any trajectory of its
// duration.
std::optional<geom::Fault> why_not_of(const ReportSummary& report,
                                      const TrajectoryRecord& trajectory);
std::optional<geom::Fault> why_not_of(const ReportSummary& report, const geom::PathRecord& path);
std::optional<geom::Fault> why_not_of(const ReportSummary& report, const FlightLog& log);

// Throws InputError(source, line, …) for anything that is not such a record: malformed JSON, no
// "ok", a refusal without a reason, a number that is not finite, an "ok" beside times without a
// return.
ReportSummary parse_report_record(std::string_view json, std::string_view source, std::size_t line);

}  // namespace traj
