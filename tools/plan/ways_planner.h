#pragma once

// Ways home for flights of any vehicle over one map.

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "cli/option/degrees.h"
#include "cli/option/scenes.h"
#include "plan/planner/plan.h"
#include "traj/home/contingency_record.h"
#include "traj/home/home_flight.h"
#include "traj/home/landing_site.h"
#include "traj/home/ways_home.h"

namespace planning {

class WaysPlanner {
 public:
  struct Options {
    std::vector<traj::DrawnSite> sites;
    std::string source;  // of these
    std::vector<traj::ReturnModel> models;
    std::optional<double> vmax;  // m/s of paths
    plan::Quality quality = plan::Quality::fast;
  };

  // Both must outlive this.
  WaysPlanner(cli::Scenes& scenes, const cli::MetresOption& metres, Options options)
      : scenes_(scenes), metres_(metres), options_(std::move(options)) {}

  struct Answer {
    traj::HomeFlight flight;
    traj::WaysHome home = {};
    bool complete = false;
    std::vector<traj::ContingencyRecord> records = {};
  };

  // Of a record of a stream. Threads may call at once.
  Answer answer(const std::string& text, const std::string& source, std::size_t line);

 private:
  // What all flights of one vehicle and margin share.
  struct Base {
    std::shared_ptr<const geom::CollisionScene> scene;
    std::unique_ptr<plan::Planner> planner;
    traj::WaysTask task;
  };

  std::shared_ptr<const Base> base_for(geom::Provenance provenance, const std::string& source,
                                       std::size_t line);
  std::shared_ptr<const Base> made(std::shared_ptr<const geom::CollisionScene> scene) const;

  cli::Scenes& scenes_;
  const cli::MetresOption& metres_;
  Options options_;
  std::mutex mutex_;  // guards what follows
  std::map<const geom::CollisionScene*, std::shared_ptr<const Base>> bases_;
};

}  // namespace planning
