#pragma once

// From a record to the bytes of its file, proved as they will be flown.

#include <optional>
#include <string>

#include "cli/option/scenes.h"
#include "cli/run.h"
#include "flight.h"
#include "options.h"
#include "writer.h"

namespace exporting {

// The exports of a run, one record at a time.
class Exporter {
 public:
  // Both must outlive this. `task`: what holds for all records.
  Exporter(const cli::Common& common, const Options& options, Task task);

  // What a record gives.
  struct Export {
    Task task;
    std::optional<Written> written;  // nothing where it was refused, which stderr says
  };
  Export make(const Flight& flight);

  // The map's, with the vehicle and margin that the last record was checked for. Only where there
  // is a check.
  const geom::CollisionScene& scene_for(const Flight& flight) {
    return scenes_->scene_for(flight.provenance, options_.input(), 0);
  }

 private:
  std::string not_for(const Flight& flight) const;
  std::optional<Written> write_checked(const Flight& flight, Task& task);

  const cli::Common& common_;
  const Options& options_;
  const Task task_;  // but for what a record says
  std::optional<cli::Scenes> scenes_;
  bool told_of_heights_ = false;  // that nobody gave: once a run
};

}  // namespace exporting
