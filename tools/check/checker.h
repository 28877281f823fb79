#pragma once

// Records and drone files held against a map and their limits.

#include <exception>
#include <optional>
#include <string>

#include "cli/content/drone_file.h"
#include "cli/file/files.h"
#include "cli/option/degrees.h"
#include "cli/option/scenes.h"
#include "cli/option/vehicle_option.h"
#include "cli/run.h"
#include "profile_file.h"
#include "reports.h"
#include "together.h"
#include "traj/check/check_record.h"
#include "traj/check/check_return.h"
#include "tubes.h"

namespace checking {

struct Rules {
  traj::RecordRules record;
  const traj::Flier* flier = nullptr;              // of drone files and returns
  std::optional<traj::ReturnRules> returns = {};   // where they are asked for
  cli::MetresOption metres = cli::MetresOption();  // whether records may be degrees
  const Tubes* tubes = nullptr;                    // of trajectories, where they are asked for
};

class Checker {
 public:
  // All must outlive this. The profile gives the clearance of what is checked, where it is open,
  // and `together` takes the trajectories, where it was asked for.
  Checker(const cli::Common& common, cli::Scenes& scenes, const ProfileFile& profile,
          Together& together, const Rules& rules)
      : common_(common), scenes_(scenes), profile_(profile), together_(together), rules_(rules) {}

  // Reports on what the shard takes of the file, in order. Returns how much is in the file.
  std::size_t each(cli::InputFile& file, const cli::DroneFileOptions& drone_file,
                   const geom::Shard& shard, Reports& reports) const;

 private:
  // What a record came to.
  struct Checked {
    Checks checks = {};
    // Of a trajectory, where `together` collects them.
    std::optional<traj::TrajectoryRecord> flight = {};
    std::optional<traj::FlightRoom> room = {};
    std::exception_ptr failure = {};  // of the check: thrown once `together` has the flight
  };
  struct Item;

  std::size_t each_record(cli::InputFile& file, const geom::Shard& shard, Reports& reports) const;
  std::size_t each_file(const std::string& text, const std::string& source,
                        const cli::DroneFileOptions& drone_file, const geom::Shard& shard,
                        Reports& reports) const;
  // Threads may call these at once.
  Checked record(const std::string& text, const std::string& source, std::size_t line) const;
  Checked trajectory(traj::TrajectoryRecord record, const std::string& source,
                     std::size_t line) const;
  Checks solved(const geom::CollisionScene& scene, const traj::TrajectoryRecord& record,
                const std::string& source, std::size_t line) const;
  Checks path(const geom::PathRecord& record, const std::string& source, std::size_t line) const;
  Checks flown(const traj::FileFlight& file) const;

  const cli::Common& common_;
  cli::Scenes& scenes_;
  const ProfileFile& profile_;
  Together& together_;
  Rules rules_;
};

}  // namespace checking
