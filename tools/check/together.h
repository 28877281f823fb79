#pragma once

// --together and --moving of skyway-check: the trajectories of a stream held against one another,
// and against obstacles that move.

#include <CLI/CLI.hpp>
#include <deque>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "cli/option/moving.h"
#include "geom/base/execution.h"
#include "geom/collision/collision.h"
#include "traj/record/pair_record.h"
#include "traj/record/trajectory_record.h"

namespace checking {

class Together {
 public:
  void add_to(CLI::App& app);
  bool asked() const { return asked_; }
  bool collects() const { return asked_ || moving_.asked(); }  // the flights
  // Whether flights stand at their ends before and after.
  bool parks() const { return collects() && task_.rule.parked == traj::Parked::pad; }
  const cli::Moving& moving() const { return moving_; }
  // Throws cli::UsageError for options that mean nothing, alone or with files of drones.
  void refuse_idle(const CLI::App& app, bool drone_file) const;

  // A record of the stream, checked over `scene`; nothing where it holds no trajectory. Throws
  // InputError(source, line, …) for an id that comes again, another epoch, no start where obstacles
  // move, and a vehicle that no distance follows from.
  void add(const traj::TrajectoryRecord& record, const geom::CollisionScene* scene,
           const std::string& source, std::size_t line);
  // Throws InputError: a path has no times.
  [[noreturn]] void refuse_path(const std::string& id, const std::string& source,
                                std::size_t line) const;

  // Leaves out flights that were refused alone, and records without a trajectory, which are among
  // `ids`.
  void drop(std::vector<std::string> ids);

  // `exact`: near pairs once more in exact numbers.
  traj::TogetherResult check(bool exact, const geom::Execution& run);
  const traj::TogetherTask& task() const { return task_; }
  std::span<const traj::TimedFlight> flights() const { return flights_; }
  std::size_t left_out() const { return left_out_; }

 private:
  const char* name() const { return asked_ ? "--together" : "--moving"; }
  void require_room(const traj::TimedFlight& flight, const std::string& source,
                    std::size_t line) const;

  bool asked_ = false;
  cli::Moving moving_;
  traj::TogetherTask task_;
  std::set<std::string> ids_;  // of all records
  bool any_ = false;           // record, yet
  std::deque<traj::Trajectory> trajectories_;
  std::vector<traj::TimedFlight> flights_;
  std::size_t left_out_ = 0;
};

}  // namespace checking
