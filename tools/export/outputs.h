#pragma once

// Where the files of a run go.

#include <optional>
#include <string>
#include <vector>

#include "cli/run.h"
#include "geom/text/output_names.h"
#include "options.h"

namespace exporting {

// The files of one record, or of all.
class Outputs {
 public:
  explicit Outputs(const Options& options);

  bool each() const { return names_[0]->each(); }

  // Throws where two records would be one file.
  void add(const std::string& id);

  // Files of an earlier run that would be taken for the record's, though it was refused.
  std::vector<std::string> stale(std::size_t index) const;

  // Of the record that was added as the `index`-th. Of many, each appears as it is whole.
  void save(std::size_t index, const traj::MissionFormat& format,
            const traj::WrittenMission& written) const;

 private:
  using Files = std::vector<std::string>;  // as Options::outputs(); empty: not asked for
  std::vector<std::optional<geom::OutputNames>> names_;
  std::string source_;
  std::vector<Files> files_;
};

void warn_of_stale(const cli::Common& common, const std::vector<std::string>& files);

}  // namespace exporting
