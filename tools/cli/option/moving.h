#pragma once

// --moving: obstacles that move, and the check of flights against them.

#include <CLI/CLI.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "degrees.h"
#include "geom/base/execution.h"
#include "named_map.h"
#include "traj/record/moving_record.h"
#include "traj/record/pair_record.h"

namespace cli {

class Moving {
 public:
  // `what` is done with them, for --help.
  void add_to(CLI::App& app, const std::string& what);
  bool asked() const { return !file_.empty(); }
  const std::string& file() const { return file_; }

  // Reads all obstacles, at least one. Throws geom::InputError for bad records, an id that comes
  // again, and epochs that differ.
  void read();
  // Once they are read, each throws geom::InputError for one of another frame, map or epoch than
  // the map has, or flights have `said`. Where these say none, obstacles still must agree. `metres`
  // refuses those whose coordinates look like degrees on the map.
  void require_of(NamedMap& map, const MetresOption& metres) const;
  void require_of(geom::Provenance said) const;
  void require_epoch(const std::optional<std::string>& flights) const;

  std::size_t count() const { return obstacles_.size(); }
  const std::string& id(std::size_t i) const { return obstacles_.at(i).id; }
  std::vector<traj::MovingBox> boxes() const;

  // Every flight against every obstacle, `task` saying who they are and how they are parked, and
  // with `exact` once more in exact numbers: conflicts in order, what was proved in exact numbers,
  // then what all came to. Throws geom::InputError where their epoch is another. The same for any
  // number of threads.
  struct Found {
    std::vector<traj::MovingConflict> conflicts;
    std::vector<traj::ProvedMoving> proved;
    traj::MovingSummary summary;
    traj::MovingClaim claim;  // holds where the summary is ok
  };
  Found check(std::span<const traj::TimedFlight> flights, const traj::TogetherTask& task,
              std::size_t left_out, bool exact, const geom::Execution& run) const;

 private:
  traj::MovingClaim claim(std::span<const traj::TimedFlight> flights,
                          const traj::TogetherTask& task) const;

  std::string file_;
  std::string name_;  // as messages say it
  std::vector<traj::MovingRecord> obstacles_;
  std::vector<std::size_t> lines_;  // where each stood
};

}  // namespace cli
