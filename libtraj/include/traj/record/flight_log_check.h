#pragma once

// Flight logs held against a map, and against the plans that they were to follow.
//
// Example:
//   traj::FlightLogCheck check;
//   traj::FlightLog log{.id = "a"};
//   log.samples = {{.time = 0, .position = {1, 1, 1}}, {.time = 0.5, .position = {1, 2, 1}}};
//   const traj::SampledReport report = check.judge(log, scene);
//   assert(traj::reason_of(report, map) == "sampled");

#include <istream>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geom/collision/collision.h"
#include "geom/record/record.h"
#include "traj/flight/flight_log.h"
#include "traj/record/sampled_report.h"
#include "traj/record/trajectory_record.h"
#include "traj/record/tube_record.h"

namespace traj {

class FlightLogCheck {
 public:
  // `rule`: what is accepted.
  explicit FlightLogCheck(const SampledRule& rule = {}) : rule_(rule) {}

  // Adds a plan. A record without a trajectory is ignored.
  void add_plan(TrajectoryRecord plan);
  bool has_plans() const { return !plans_.empty(); }

  // Takes a tube of each plan; they are in these axes. Throws InputError as TubeReports, and where
  // a plan has none.
  void read_tubes(std::istream& in, const std::string& source, geom::Axes axes = geom::Axes::enu);

  // Whether a log has a plan. The plan with the id of the log counts, or else the only plan.
  bool has_plan(const FlightLog& log) const { return plan_of(log.id) != nullptr; }

  // The map and vehicle that a log is of, as far as it and its plan say.
  geom::Provenance made_for(const FlightLog& log) const;

  // Ids of the plans that no log is of.
  std::vector<std::string> plans_without(std::span<const FlightLog> logs) const;

  SampledReport judge(const FlightLog& log, const geom::CollisionScene& scene) const;

 private:
  struct Plan {
    TrajectoryRecord record;
    std::optional<TubeRecord> tube;
  };
  const Plan* plan_of(const std::string& id) const;

  SampledRule rule_;
  std::vector<Plan> plans_;
};

}  // namespace traj
