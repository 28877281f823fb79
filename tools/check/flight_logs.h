#pragma once

// Flight logs held against a map, and against the plan they were to follow.

#include <optional>
#include <string>

#include "cli/batch.h"
#include "cli/content/contents.h"
#include "cli/option/scenes.h"
#include "cli/shard/record_output.h"
#include "traj/record/sampled_report.h"

namespace checking {

class FlightLogs {
 public:
  void add_to(CLI::App& app);
  // Throws cli::UsageError for options that mean nothing of a flight log, and the other way round.
  void refuse_idle(const CLI::App& app, bool asked) const;
  const std::string& plan() const { return plan_; }
  const std::string& tube() const { return tube_; }

  // A report a flight. Never Exit::yes.
  cli::Exit check(const cli::Common& common, const std::string& input, cli::Scenes& scenes,
                  const cli::MetresOption& metres, const cli::Sharding& sharding,
                  const std::string& output);

 private:
  struct Plan {
    traj::TrajectoryRecord record;
    std::optional<traj::TubeRecord> tube;
  };

  void read_plan(const geom::BoxMap& map, const cli::MetresOption& metres);
  static void require_whole(const traj::TubeRecord& tube, const Plan& plan,
                            const geom::JsonFields& fields);
  void read_tubes();
  const Plan* plan_of(const std::string& id) const;
  traj::SampledReport report_of(const traj::FlightLog& log, cli::Scenes& scenes,
                                const std::string& source) const;

  std::string plan_;
  std::string tube_;
  std::vector<Plan> plans_;
};

}  // namespace checking
