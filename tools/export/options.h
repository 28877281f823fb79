#pragma once

// What the user asked of skyway-export.

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "cli/option/degrees.h"
#include "cli/option/vehicle_option.h"
#include "traj/together/spacing.h"
#include "traj/together/timed_flight.h"
#include "writer.h"

namespace exporting {

struct Options {
  std::vector<std::string> files;
  std::string output = "-";
  std::string python;  // of a Tello, beside its script; empty: not asked for
  std::string table;
  std::string show;  // a folder for the files of all; empty: not asked for
  std::string id;
  std::string axes = "enu";
  bool unchecked = false;
  bool hover = false;
  cli::VehicleOptions vehicle;
  cli::MetresOption metres;
  traj::Spacing spacing;  // of the flights of a show
  traj::Parked parked = traj::Parked::pad;

  std::string input() const { return files.size() > map_files() ? files.back() : "-"; }
  std::string source() const { return input() == "-" ? "stdin" : input(); }  // for messages
  std::size_t map_files() const { return unchecked ? 0 : 1; }

  // Both must outlive the app.
  void add_to(CLI::App& app, Task& task);

  // Throws cli::UsageError for options that do not go together, or mean nothing here.
  void require_sound(const CLI::App& app, const Task& task) const;

 private:
  void require_outputs() const;
};

}  // namespace exporting
