#pragma once

// --profile of skyway-check: the least clearance along the way, CSV.

#include <optional>
#include <span>
#include <string>

#include "cli/shard/record_output.h"
#include "traj/proof/clearance.h"

namespace checking {

class ProfileFile {
 public:
  void add_to(CLI::App& app);
  const std::string& file() const { return file_; }  // empty: not asked for
  double step() const { return step_; }              // seconds, or metres along a path

  void open(const cli::Sharding& sharding);  // which must outlive this
  bool is_open() const { return out_.has_value(); }
  // Throws UsageError where a way so long (seconds, or metres) has more parts than can be written.
  void require_room(double extent) const;
  void add(const std::string& id, std::span<const traj::ClearanceSpan> spans);
  void finish_record();  // what was added since the last is of one record
  void commit(std::size_t total, cli::Exit exit);

 private:
  std::string file_;
  double step_ = 0.1;
  std::optional<cli::RecordOutput> out_;
  std::string lines_;
};

}  // namespace checking
