#pragma once

// --together and --moving of skyway-check: the trajectories of a stream held against one another,
// and against obstacles that move.

#include <CLI/CLI.hpp>
#include <optional>
#include <span>
#include <string>

#include "cli/option/moving.h"
#include "traj/check/flight_set.h"

namespace checking {

class Together {
 public:
  void add_to(CLI::App& app);
  bool asked() const { return asked_; }
  bool collects() const { return asked_ || moving_.asked(); }  // the flights
  // Whether flights stand at their ends before and after.
  bool parks() const { return collects() && rule_.parked == traj::Parked::pad; }
  const cli::Moving& moving() const { return moving_; }
  // Throws cli::UsageError for options that mean nothing, alone or with files of drones.
  void refuse_idle(const CLI::App& app, bool drone_file) const;

  // traj::FlightSet::add; call where flights are collected.
  void add(traj::TrajectoryRecord record, const std::optional<traj::FlightRoom>& room,
           const std::string& source, std::size_t line);
  // Throws InputError: a path has no times.
  [[noreturn]] void refuse_path(const std::string& id, const std::string& source,
                                std::size_t line) const;

  // Leaves out flights that were refused alone, and records without a trajectory, which are among
  // `ids`.
  void drop(std::vector<std::string> ids) { set_->drop(std::move(ids)); }

  // Once a record was added.
  traj::TogetherResult check(bool exact, const geom::Execution& run) {
    return set_->check(exact, run);
  }
  const traj::TogetherTask& task() const { return set_->task(); }
  std::span<const traj::TimedFlight> flights() const { return set_->flights(); }
  std::size_t left_out() const { return set_->left_out(); }

 private:
  const char* name() const { return asked_ ? "--together" : "--moving"; }

  bool asked_ = false;
  cli::Moving moving_;
  traj::TogetherRule rule_;
  std::optional<traj::FlightSet> set_;
};

}  // namespace checking
