#pragma once

// Whether the contingencies of a flight hold, and cover all of it.
//
// Example:
//   traj::ContingencyRules rules;
//   rules.models = {traj::return_model(traj::px4("1.17"))};
//   const std::vector<traj::ContingencyRecord> none;
//   const auto report =
//       traj::check_contingencies(scene, "q1", traj::stages_of(trajectory), none, rules);
//   assert(report.result.reason == traj::Reason::return_home);  // no way from anywhere

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geom/collision/collision.h"
#include "traj/flight/energy.h"
#include "traj/home/contingency_record.h"
#include "traj/home/flight_stage.h"
#include "traj/home/return_model.h"
#include "traj/record/report_record.h"

namespace traj {

struct ContingencyRules {
  std::vector<ReturnModel> models;    // any of which may brake
  std::optional<Energy> energy = {};  // to be enough up to each record's latest departure, and
                                      // that to be its `until`
  double finest = 0.5;                // m: shorter stages are not divided
};

// Proves the records of one flight (in any order) anew, by its own stages. Of the records only
// their times, points and latest departures count. For each: every leg is inside the bounds and
// clear, the last goes straight down to whole and level ground; and from every instant of its time
// the region of braking and all straight ways to the first point are inside the bounds and clear.
// Together they leave out no instant. The report, "checked":"contingency", has the first reason in
// time: collision, landing, endurance, or, if all records hold, return where there is no way
// (`worst`: seconds without one); `detail` says it in words.
// Nothing is sampled.
ReportRecord check_contingencies(const geom::CollisionScene& scene, const std::string& id,
                                 std::span<const FlightStage> stages,
                                 std::span<const ContingencyRecord> records,
                                 const ContingencyRules& rules);

}  // namespace traj
