#pragma once

// From a record to the bytes of its file, proved as they will be flown.

#include <optional>
#include <set>
#include <string>

#include "cli/option/scenes.h"
#include "cli/run.h"
#include "flight.h"
#include "options.h"

namespace exporting {

// The exports of a run, one record at a time.
class Exporter {
 public:
  // Both must outlive this.
  Exporter(const cli::Common& common, const Options& options);

  // The record's file; nothing where it was refused, which stderr says.
  std::optional<traj::WrittenMission> make(const Flight& flight);

  // The map's, with the vehicle and margin that the last record was checked for. Only where there
  // is a check.
  const geom::CollisionScene& scene_for(const Flight& flight) {
    return scenes_->scene_for(flight.provenance, options_.input(), 0);
  }
  // In which the flight is: the map's or, without one, what the record says.
  geom::Frame frame_of(const Flight& flight);

 private:
  traj::MissionExport export_checked(const Flight& flight);
  traj::MissionExport export_unchecked(const Flight& flight);
  void require_vehicle(const Flight& flight) const;
  traj::MissionExport export_one(const Flight& flight);

  const cli::Common& common_;
  const Options& options_;
  std::optional<cli::Scenes> scenes_;
  traj::ReturnWishes wishes_;
  std::set<std::string> told_;  // warnings, each once a run
};

}  // namespace exporting
