#pragma once

// The flights of a folder: proved one by one, and their files.

#include <optional>
#include <string>
#include <vector>

#include "cli/run.h"
#include "geom/text/output_names.h"
#include "submission_folder.h"
#include "traj/check/flight_set.h"
#include "traj/submit/flight_parts.h"
#include "traj/submit/submission.h"
#include "traj/submit/submitted_flights.h"

namespace submitting {

class FlightFiles {
 public:
  // All must outlive this.
  // Where trajectories are compared, by `together`.
  FlightFiles(const cli::Common& common, const traj::SubmittedFlights& flights,
              SubmissionFolder& folder, const std::optional<traj::TogetherRule>& together)
      : common_(common), flights_(flights), folder_(folder) {
    if (together) set_.emplace(*together);
  }

  // Reads a file to its end: records, or a mission. Refusals are told on stderr.
  void add(const std::string& path, const geom::BoxMap& map);

  // The rest of the files; once, after all were added.
  void write();

  // Compares the trajectories, and adds pairs.jsonl and pair_certificates.jsonl. Nothing where that
  // was not asked for.
  std::optional<traj::FlightPairs> compare();

  std::size_t refused() const { return refused_; }
  std::size_t count() const { return claims_.size(); }  // after write() of all
  bool has_records() const { return has_records_; }
  // Of missions, those that were refused, too: what they need of the ground, and whether one ends
  // with a return to home.
  const traj::TerrainUse& terrain_use() const { return terrain_use_; }
  bool ends_at_home() const { return ends_at_home_; }
  const std::vector<std::string>& missions() const { return missions_; }
  std::vector<traj::FlightClaims>& claims() { return claims_; }  // in their order
  // The ground risk buffers of each of them.
  const std::vector<std::vector<traj::RiskVolume>>& buffers() const { return buffers_; }

 private:
  // What a flight came to.
  struct Made {
    traj::FlightParts parts = {};
    std::string record = {};          // its line
    traj::FlightInScene flight = {};  // of a record, where flights are compared
    std::size_t line = 0;
  };

  void take(Made made, const std::string& source);
  void take_record(const Made& made, const std::string& source);
  void add_mission(const std::string& path, const std::string& text, const geom::BoxMap& map);

  const cli::Common& common_;
  const traj::SubmittedFlights& flights_;
  SubmissionFolder& folder_;
  geom::OutputNames names_{"%s", "--output"};
  std::optional<GrowingFile> records_;
  std::optional<GrowingFile> certificates_;
  bool has_records_ = false;
  traj::TerrainUse terrain_use_;
  bool ends_at_home_ = false;
  std::optional<traj::FlightSet> set_;  // of trajectories, where they are compared
  std::vector<std::string> missions_;
  std::vector<traj::FlightClaims> claims_;
  std::vector<std::vector<traj::RiskVolume>> buffers_;
  std::vector<Made> of_missions_;  // after those of the records
  std::size_t refused_ = 0;
};

}  // namespace submitting
