#pragma once

// What skyway-check writes of each record and of all flights together.

#include <optional>
#include <string>
#include <vector>

#include "cli/batch.h"
#include "cli/beyond_bounds.h"
#include "cli/file/files.h"
#include "cli/shard/record_output.h"
#include "profile_file.h"
#include "report_output.h"
#include "together.h"
#include "traj/record/junit_suite.h"
#include "traj/record/verdict_table.h"

namespace checking {

// What the check of a record gave.
struct Checks {
  traj::ReportRecord report = {};
  std::string profile = {};  // rows of the profile
};

// The same, in words and as lines.
struct Told {
  Checks checks = {};
  bool ok = false;
  std::string line = {};         // the record of the report, unless a table has it
  std::string certificate = {};  // a line, where it is asked for
  std::string sentence = {};     // why it was refused
};

// Where all that goes.
struct ReportFiles {
  const ReportOutput& report;
  const std::string& certificate;  // empty: none
  ProfileFile& profile;
  const std::string& junit;  // empty: none
  bool parks = false;        // flights stand at their ends
  bool drop_refused = false;
};

// Writes what each record came to, and counts.
class Reports {
 public:
  // All must outlive this.
  Reports(const ReportFiles& files, const cli::Sharding& sharding, const geom::BoxMap& map);

  Told told(Checks checks) const;  // threads may call at once, also with what follows
  void add(Told told);

  // Of all flights against one another.
  void add(const Together& together, const traj::TogetherResult& result);

  // Of all flights against obstacles that move.
  void add(const traj::MovingObstacles::Found& found);

  // `total`: how many records all shards have.
  cli::Exit commit(std::size_t total);

  // Ids of refused records that are left out.
  const std::vector<std::string>& dropped() const { return dropped_; }
  // Whether stderr says what failed.
  bool tells() const { return files_.report.tells(); }

  const cli::BeyondBounds& beyond() const { return beyond_; }

  std::size_t count() const { return count_; }
  std::size_t failed() const { return failed_; }
  const cli::Batch& batch() const { return batch_; }

 private:
  std::string certificate(const traj::ReportRecord& report) const;
  std::string way_certificate(const traj::ReportRecord& report) const;

  ReportFiles files_;
  const geom::BoxMap& map_;
  std::optional<cli::OutputFile> junit_;
  traj::JUnitSuite suite_;  // where it is written
  std::optional<traj::VerdictTable> table_;
  cli::BeyondBounds beyond_;
  cli::RecordOutput out_;
  std::optional<cli::RecordOutput> certificates_;
  std::size_t count_ = 0;
  std::size_t failed_ = 0;   // records
  std::size_t refused_ = 0;  // of the checks of all flights
  std::vector<std::string> dropped_;
  cli::Batch batch_;
};

}  // namespace checking
