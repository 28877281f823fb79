#pragma once

// Records and drone files held against a map and their limits.

#include <functional>
#include <string>

#include "cli/content/drone_file.h"
#include "cli/file/files.h"
#include "cli/option/degrees.h"
#include "cli/option/scenes.h"
#include "cli/option/vehicle_option.h"
#include "cli/run.h"
#include "profile_file.h"
#include "together.h"
#include "traj/check/check_record.h"

namespace checking {

struct Rules {
  traj::RecordRules record;
  const traj::Flier* flier = nullptr;              // of drone files
  cli::MetresOption metres = cli::MetresOption();  // whether records may be degrees
};

class Checker {
 public:
  // All must outlive this. The profile takes the clearance of what is checked, where it is open,
  // and `together` the trajectories, where it was asked for.
  Checker(const cli::Common& common, cli::Scenes& scenes, ProfileFile& profile, Together& together,
          const Rules& rules)
      : common_(common), scenes_(scenes), profile_(profile), together_(together), rules_(rules) {}

  using Answer = std::function<void(const traj::ReportRecord&)>;
  // Answers what the shard takes of the file, in order. Returns how much is in the file.
  std::size_t each(cli::InputFile& file, const cli::DroneFileOptions& drone_file,
                   const geom::Shard& shard, const Answer& answer) const;

 private:
  traj::ReportRecord record(const std::string& text, const std::string& source,
                            std::size_t line) const;
  traj::ReportRecord trajectory(const traj::TrajectoryRecord& record, const std::string& source,
                                std::size_t line) const;
  traj::ReportRecord path(const geom::PathRecord& record, const std::string& source,
                          std::size_t line) const;
  traj::ReportRecord flown(const traj::FileFlight& file) const;

  const cli::Common& common_;
  cli::Scenes& scenes_;
  ProfileFile& profile_;
  Together& together_;
  Rules rules_;
};

}  // namespace checking
