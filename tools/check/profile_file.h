#pragma once

// --profile of skyway-check: the least clearance along the way, CSV.

#include <optional>
#include <string>

#include "cli/shard/record_output.h"
#include "traj/proof/clearance.h"

namespace checking {

class ProfileFile {
 public:
  void add_to(CLI::App& app);
  const std::string& file() const { return file_; }  // empty: not asked for

  void open(const cli::Sharding& sharding);  // which must outlive this
  // The profile of a way, where it is open. Throws UsageError where a way so long (seconds, or
  // metres) has more parts than can be written.
  void add(const std::string& id, const geom::CollisionScene& scene,
           const traj::Trajectory& trajectory, double duration);
  void add(const std::string& id, const geom::CollisionScene& scene, const geom::Polyline& path);
  void finish_record();  // what was added since the last is of one record
  void commit(std::size_t total, cli::Exit exit);

 private:
  void require_room(double extent) const;

  std::string file_;
  double step_ = 0.1;  // seconds, or metres along a path
  std::optional<cli::RecordOutput> out_;
  std::string lines_;
};

}  // namespace checking
