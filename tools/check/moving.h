#pragma once

// --moving of skyway-check: obstacles that move, held against each flight.

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geom/base/execution.h"
#include "geom/map/box_map.h"
#include "traj/record/moving_record.h"
#include "traj/record/pair_record.h"

namespace checking {

class Moving {
 public:
  void add_to(CLI::App& app);
  bool asked() const { return !file_.empty(); }
  const std::string& file() const { return file_; }

  // Reads all obstacles, at least one. Throws geom::InputError for bad records, an id that comes
  // again, epochs that differ, and a frame or map that is not this one.
  void read(const geom::BoxMap& map);

  // Every flight against every obstacle, `task` saying who they are and how they are parked:
  // conflicts in order, then what all came to. Throws geom::InputError where their epoch is
  // another. The same for any number of threads.
  struct Found {
    std::vector<traj::MovingConflict> conflicts;
    traj::MovingSummary summary;
  };
  Found check(std::span<const traj::TimedFlight> flights, const traj::TogetherTask& task,
              std::size_t left_out, const geom::Execution& run) const;

 private:
  std::string file_;
  std::vector<traj::MovingRecord> obstacles_;
};

}  // namespace checking
