#pragma once

// A flight of a stream of records and the autopilots that may fly it, as ways home see them.
//
// Example:
//   const geom::PathRecord record{.id = "q1", .status = geom::PathStatus::found, .points = path};
//   const std::vector<traj::FlightStage> stages = traj::stages_of(record, 5);  // m/s
//   assert(stages.size() == path.size() - 1);

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geom/record/record.h"
#include "geom/text/json_fields.h"
#include "traj/home/flight_stage.h"
#include "traj/home/return_model.h"
#include "traj/mission/formats/flier.h"

namespace traj {

struct HomeFlight {
  std::string id;
  geom::Provenance provenance;
  std::vector<FlightStage> stages;  // empty: there is no flight
  std::string without = {};         // why not, in words
  std::string kind = "trajectory";  // the type of its record, or "path"
  std::string checked_hash = {};    // of the record (traj/record/checked_hash.h)

  // One for each stage.
  std::vector<Vec3> places() const;
};

// Of a record of a trajectory, or of a path that is flown with `vmax`, m/s; without it with what
// its vehicle's limits allow. Throws InputError for what is no such record, and UsageError for a
// path whose speed nobody says.
HomeFlight read_home_flight(const geom::JsonFields& fields, const std::optional<double>& vmax);

// Throws UsageError where `vmax` is given and none of the flights was a path: trajectories have
// speeds of their own.
void require_vmax_used(const std::optional<double>& vmax, bool any_path);

// A stage for each leg, which lasts its length over `speed` (m/s, > 0), and one for each hold.
std::vector<FlightStage> stages_of(const geom::PathRecord& path, double speed);

// The models of the flier's autopilots. How wrong the vehicle may be about its place is part of
// their `around`.
std::vector<ReturnModel> return_models(const Flier& flier);

// The margin that holds how far the models may be off, m.
double least_margin(std::span<const ReturnModel> models);

}  // namespace traj
