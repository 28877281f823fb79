#pragma once

// All trajectories of a stream, flown.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cli/batch.h"
#include "cli/file/files.h"
#include "cli/option/scenes.h"
#include "cli/shard/record_output.h"
#include "options.h"
#include "traj/flight/run_part.h"
#include "traj/record/flight_report.h"
#include "traj/record/trajectory_record.h"

namespace fly {

struct Tally {
  std::size_t records = 0;
  std::size_t failed = 0;
  cli::Batch batch;
  double flown = 0;  // s of simulated flight, hovering included
  double cpu = 0;    // s that simulating it took, of all threads
};

class Mission {
 public:
  Mission(const Options& options, const cli::VehicleOptions& vehicle,
          const std::optional<geom::BoxMap>& map);

  // Those trajectories that the shard takes. Returns how many there are.
  std::size_t read(cli::InputFile& file, const geom::Shard& shard);

  // The runs of a share, of each solved trajectory.
  std::vector<std::vector<traj::RunOutcome>> fly_runs(const geom::Shard& shard,
                                                      const geom::Execution& run) const;

  // Runs that need not be flown. Throws geom::InputError where they are not of these trajectories.
  void take(traj::JoinedRuns runs);

  // The log's rows of each flight and a line of the report each, in order.
  Tally fly(const geom::Execution& run, cli::RecordOutput& log, cli::RecordOutput* report);

  traj::TuneResult tune(const geom::Execution& run) const;

 private:
  struct Entry {
    traj::TrajectoryRecord record;
    std::size_t line;
  };

  geom::Axes axes(const Entry& entry) const;
  std::string map_of(const Entry& entry) const;  // its hash; empty where nothing names one
  [[noreturn]] void refuse_size(const geom::Vehicle& made_for, std::size_t line) const;
  void require_vehicle(const Entry& entry) const;
  const geom::CollisionScene& scene_for(const Entry& entry);
  traj::ReferenceTrack track_of(const Entry& entry) const;
  traj::FlightReport report_of(const Entry& entry, const traj::ReferenceTrack* track,
                               const traj::Flight& flight);
  void add_runs(const Entry& entry, std::span<const traj::RunOutcome> runs,
                traj::FlightReport& report);
  void judge(const Entry& entry, const traj::Flight& flight, traj::FlightReport& report);

  Options options_;
  traj::VehicleProfile profile_;
  traj::FlightOptions flight_;
  std::optional<cli::Scenes> scenes_;
  std::string source_;
  std::vector<Entry> entries_;
  std::optional<traj::JoinedRuns> joined_;
};

}  // namespace fly
