#pragma once

// --profile of skyway-check: the least clearance along the way, CSV.

#include <optional>
#include <string>

#include "cli/shard/record_output.h"
#include "geom/shape/polyline.h"
#include "traj/proof/clearance.h"

namespace checking {

class ProfileFile {
 public:
  void add_to(CLI::App& app);
  const std::string& file() const { return file_; }  // empty: not asked for

  void open(const cli::Sharding& sharding);  // which must outlive this
  // The profile of a way, empty unless the file is open. Throws UsageError where a way so long
  // (seconds, or metres) has more parts than can be written. Threads may call at once.
  std::string rows(const std::string& id, const geom::CollisionScene& scene,
                   const traj::Trajectory& trajectory, double duration) const;
  std::string rows(const std::string& id, const geom::CollisionScene& scene,
                   const geom::Polyline& path) const;
  void add(const std::string& rows);  // of one record
  void commit(std::size_t total, cli::Exit exit);

 private:
  void require_room(double extent) const;

  std::string file_;
  double step_ = 0.1;  // seconds, or metres along a path
  std::optional<cli::RecordOutput> out_;
};

}  // namespace checking
