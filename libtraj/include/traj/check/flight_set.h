#pragma once

// The flights of a stream of records, for the check of all against one another.
//
// Example:
//   traj::TrajectoryRecord record{.id = "q1", .status = traj::TrajectoryStatus::solved};
//   record.trajectory = trajectory;
//   traj::FlightSet flights(traj::TogetherRule{});
//   flights.add(record, &scene, "flights.jsonl", 1);
//   assert(flights.check().ok());

#include <cstddef>
#include <deque>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geom/base/execution.h"
#include "geom/collision/collision.h"
#include "traj/record/pair_record.h"
#include "traj/record/trajectory_record.h"

namespace traj {

// What the scene of a record says of its flight.
struct FlightRoom {
  std::string map;  // its hash
  Vec3 half = Vec3::Zero();
  bool overridden = false;      // smaller than what the record asks for
  Vec3 vehicle = Vec3::Zero();  // half sizes without the margin
};
FlightRoom room_of(const geom::CollisionScene& scene, const TrajectoryRecord& record);

// Holds the trajectories that its flights point to: not to be copied.
class FlightSet {
 public:
  // What every flight must have. `room`: a size along each axis; a rule with a distance of its own
  // does not need it. `start`: a time of departure.
  struct Needs {
    bool room = true;
    bool start = false;
  };

  explicit FlightSet(TogetherRule rule) : FlightSet(rule, Needs{}) {}
  FlightSet(TogetherRule rule, Needs needs) : needs_(needs), vehicles_(rule.spacing.zone) {
    task_.rule = std::move(rule);
  }
  FlightSet(const FlightSet&) = delete;
  FlightSet& operator=(const FlightSet&) = delete;

  // A record with the room of the scene that it was checked in. One that holds no trajectory (no
  // `room`, or `scene` is null),
  // or one that no distance can be computed of (domain.h), counts as left out. Throws
  // InputError(source, line, …) for an id that comes again, for another epoch than that of the
  // first record, and for a flight that lacks what is needed. Throws UsageError for a zone that is
  // smaller than two of the vehicles (VehiclesInZone).
  void add(TrajectoryRecord record, const std::optional<FlightRoom>& room, std::string_view source,
           std::size_t line);
  void add(const TrajectoryRecord& record, const geom::CollisionScene* scene,
           std::string_view source, std::size_t line);

  // Leaves out flights by their ids: those that were refused alone, and every record without a
  // trajectory, which must be among them. The task names them (TogetherTask::dropped).
  void drop(std::vector<std::string> ids);

  // All pairs by the rule; near ones once more in exact numbers if `exact`. The same for any number
  // of threads.
  TogetherResult check(bool exact = false, const geom::Execution& run = {});

  const TogetherTask& task() const { return task_; }
  std::span<const TimedFlight> flights() const { return flights_; }  // of the ids of the task
  std::size_t left_out() const { return left_out_; }

 private:
  void require_needs(const TrajectoryRecord& record, const TimedFlight& flight,
                     std::string_view source, std::size_t line) const;

  Needs needs_;
  VehiclesInZone vehicles_;
  TogetherTask task_;
  std::set<std::string> ids_;  // of all records
  std::deque<Trajectory> trajectories_;
  std::vector<TimedFlight> flights_;
  std::size_t left_out_ = 0;
};

}  // namespace traj
