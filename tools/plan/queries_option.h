#pragma once

// What skyway-plan is asked: --from and --to, or --queries.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/option/degrees.h"
#include "geom/map/box_map.h"
#include "geom/record/query_record.h"

namespace planning {

class QueriesOption {
 public:
  CLI::Option* add_to(CLI::App& app);  // returns --queries

  void require_some() const;  // throws cli::UsageError
  const std::string& file() const { return file_; }

  // Places on Earth become metres of the map; ends in metres that look like degrees are refused.
  std::vector<geom::PlanQuery> read(const geom::BoxMap& map) const;

 private:
  std::optional<geom::Place> from_;
  std::optional<geom::Place> to_;
  std::string file_;
  cli::MetresOption metres_{true};
};

}  // namespace planning
