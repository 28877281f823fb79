#pragma once

// What may be asked of a mission's return: rally points, fences, heights, parameters, words.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

#include "traj/home/return_export.h"

namespace exporting {

class ReturnOptions {
 public:
  void add_to(CLI::App& app);

  // Throws cli::UsageError for options that mean nothing without others. `word`: of the format.
  void require_sound(const CLI::App& app, const std::string& word, bool unchecked) const;

  // Reads the files that are named. `volumes`: how many there may be at most. `frame`: of the map,
  // with the origin that the user gave.
  traj::ReturnWishes wishes(const geom::Frame& frame, std::size_t volumes) const;

  std::string fences_out;  // files beside the mission; empty: not asked for
  std::string rally_out;
  std::string params_out;
  std::string procedure;

 private:
  std::vector<geom::Vec3> rally_points(const geom::Frame& frame) const;

  std::vector<std::string> rally_;
  std::string fence_;
  std::optional<std::size_t> budget_;
  std::optional<double> height_;
  bool returns_ = false;
};

}  // namespace exporting
