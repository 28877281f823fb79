#pragma once

// What skyway-plan is asked: --from and --to, or --queries.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/option/degrees.h"
#include "geom/collision/collision.h"
#include "geom/record/query_record.h"

namespace planning {

class QueriesOption {
 public:
  void add_to(CLI::App& app);

  // Throws cli::UsageError where there is nothing to plan, or one query for several shards.
  void require_some(bool sharded) const;
  const std::string& file() const { return file_; }
  const cli::MetresOption& metres() const { return metres_; }

  // Places on Earth become metres of the map; ends in metres that look like degrees are refused.
  std::vector<geom::PlanQuery> read(const geom::CollisionScene& scene) const;

 private:
  std::optional<geom::Place> from_;
  std::optional<geom::Place> to_;
  std::string file_;
  cli::MetresOption metres_{true};
};

}  // namespace planning
