#pragma once

// What the user asked of skyway-export.

#include <CLI/CLI.hpp>
#include <array>
#include <string>
#include <vector>

#include "cli/option/autopilot_option.h"
#include "cli/option/degrees.h"
#include "cli/option/vehicle_option.h"
#include "return_options.h"
#include "traj/together/spacing.h"
#include "traj/together/timed_flight.h"

namespace exporting {

struct Options {
  std::string word;          // of the format
  traj::ExportOptions file;  // what is asked of each file; settle() gives the rest
  cli::AutopilotOptions autopilot;
  std::vector<std::string> files;
  std::string output = "-";
  std::string python;  // of a Tello, beside its script; empty: not asked for
  std::string table;
  std::string tube;  // reports with proved tubes, of volumes of airspace; empty: none
  ReturnOptions returns;
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

  bool is_geopackage() const { return word == "gpkg"; }
  const traj::MissionFormat& format() const {
    return *traj::mission_format_named(is_geopackage() ? "geojson" : word);
  }

  // Must outlive the app.
  void add_to(CLI::App& app);

  // Throws cli::UsageError for options that do not go together, or mean nothing here.
  void require_sound(const CLI::App& app) const;

  // Completes `file`, with what the vehicle's profile and the autopilot's parameters say.
  void settle();

  // All files of one flight, and the options that name them: the drone file, then what may stand
  // beside it. Empty names: not asked for.
  struct Output {
    std::string name;
    const char* option;
  };
  std::array<Output, 7> outputs() const;

 private:
  void require_outputs() const;
};

}  // namespace exporting
