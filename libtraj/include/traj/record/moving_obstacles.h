#pragma once

// Obstacles that move, and the check of flights against them.
//
// Example:
//   std::istringstream file(
//       R"({"type":"moving","id":"crane","epoch":"2026-05-04T06:30:00Z","from":0,"until":60,)"
//       R"("min":[0,0,0],"max":[2,2,9],"velocity":[0.1,0,0],"growth":[0,0,0]})");
//   const traj::MovingObstacles moving(file, "moving.jsonl");
//   assert(moving.count() == 1 && moving.id(0) == "crane");

#include <functional>
#include <istream>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geom/base/execution.h"
#include "geom/record/named_map.h"
#include "traj/record/moving_record.h"
#include "traj/record/pair_record.h"

namespace traj {

class MovingObstacles {
 public:
  // Reads all obstacles, at least one. Throws geom::InputError for bad records, an id that comes
  // again, and epochs that differ.
  MovingObstacles(std::istream& in, std::string source);

  // Each throws geom::InputError for one of another frame, map or epoch than the map has, or
  // flights have `said`. Where these say none, obstacles still must agree. `look_at` is asked of
  // each that is of the map, with its source and line, and may throw.
  using LookAt = std::function<void(const geom::Aabb&, const std::string&, std::size_t)>;
  void require_of(geom::NamedMap& map, const LookAt& look_at) const;
  void require_of(geom::Provenance said) const;
  void require_epoch(const std::optional<std::string>& flights) const;

  std::size_t count() const { return obstacles_.size(); }
  const std::string& id(std::size_t i) const { return obstacles_.at(i).id; }
  std::vector<MovingBox> boxes() const;

  // Every flight against every obstacle, `task` saying who they are and how they are parked, and
  // with `exact` once more in exact numbers: conflicts in order, what was proved in exact numbers,
  // then what all came to. Throws geom::InputError where their epoch is another. The same for any
  // number of threads.
  struct Found {
    std::vector<MovingConflict> conflicts;
    std::vector<ProvedMoving> proved;
    MovingSummary summary;
    MovingClaim claim;  // holds where the summary is ok
  };
  Found check(std::span<const TimedFlight> flights, const TogetherTask& task, std::size_t left_out,
              bool exact, const geom::Execution& run) const;

 private:
  MovingClaim claim(std::span<const TimedFlight> flights, const TogetherTask& task) const;

  std::string name_;  // as messages say it
  std::vector<MovingRecord> obstacles_;
  std::vector<std::size_t> lines_;  // where each stood
};

}  // namespace traj
