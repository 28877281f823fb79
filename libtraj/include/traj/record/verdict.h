#pragma once

// Verdicts in sentences: what is wrong, when and where, and what to do.
//
// Example:
//   traj::ReportRecord report{.id = "q1", .checked = "trajectory"};
//   report.result = traj::check(scene, trajectory, limits);
//   assert(traj::in_words(report, map).starts_with("clear for "));
//   report.result = traj::check_path(scene, {{{1, 1, 1}, {9, 9, 1}}});
//   std::cout << traj::in_words(report, map) << '\n';  // the vehicle reaches 0.7 m into obstacle …
//
// Sentences are one line, for people. Programs read the records.

#include <string>
#include <string_view>

#include "geom/map/box_map.h"
#include "traj/record/flight_report.h"
#include "traj/record/report_record.h"
#include "traj/record/sampled_report.h"
#include "traj/record/trajectory_record.h"

namespace traj {

// What a result was held to.
struct HeldTo {
  Limits limits = {};
  Vec3 half = Vec3::Zero();  // m, of the vehicle with its margin
};
// Those of a record; a half size of 0 where it has no vehicle.
HeldTo held_of(const geom::Provenance& provenance, const Limits& limits = {});

// What a check refuses, without time and place: "the vehicle reaches 0.413 m into obstacle 7". An
// obstacle is named by its id in the source and its label. `map` is the one that was looked at.
// Says so, too, where nothing is refused.
std::string fault_in_words(const CheckResult& result, const geom::BoxMap& map,
                           const HeldTo& held = {});

// What to do about a refused report; may be empty.
std::string advice_for(const ReportRecord& report);

// The whole verdict without the record's id. Of an accepted one: how long it is clear, and by how
// much. Of a refused one: fault, item of a mission, time, place, and what to do.
std::string in_words(const ReportRecord& report, const geom::BoxMap& map);

// What the verdict on an accepted report rests on or leaves out: the autopilots and errors that
// were taken, limits that were not measured, what was made looser. Empty where there is nothing to
// say.
std::string rests_on_in_words(const ReportRecord& report);
std::string rests_on_in_words(const SampledReport& report);

// A time without a proved return: "from 12.3 s to 15.2 s no way home is proved: in the climb the
// vehicle meets obstacle 7, near …".
std::string in_words(const ReturnGap& gap, const geom::BoxMap& map);

// Why the map is not clear with a tube around a trajectory that was made for `over`.
std::string in_words(const TubeReport& tube, geom::Provenance over, const geom::BoxMap& map);

// Of a simulated flight, over `map` where there is one.
std::string in_words(const FlightReport& report, const geom::BoxMap* map);

// Why a record holds no trajectory, and what to do.
std::string in_words(const TrajectoryRecord& record);

// Of a flight log: what was seen at its samples and straight between them, and what was not
// measured.
std::string in_words(const SampledReport& report, const geom::BoxMap& map);

// "collision", "exact" where only the exact check refuses, "ok" where nothing does.
std::string_view verdict_word(const ReportRecord& report);

}  // namespace traj
