#pragma once

// --moving: obstacles that move.

#include <CLI/CLI.hpp>
#include <string>

#include "degrees.h"
#include "traj/record/moving_obstacles.h"

namespace cli {

class Moving {
 public:
  // `what` is done with them, for --help.
  void add_to(CLI::App& app, const std::string& what);
  bool asked() const { return !file_.empty(); }
  const std::string& file() const { return file_; }

  traj::MovingObstacles read() const;  // of the file

 private:
  std::string file_;
};

// Refuses obstacles whose coordinates look like degrees on the map.
traj::MovingObstacles::LookAt look_at_boxes(const MetresOption& metres, const geom::Frame& frame);

}  // namespace cli
