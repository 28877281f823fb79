#pragma once

// What an accepted verdict rests on or leaves out, of a report as it is made and as it is read.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geom/text/json_fields.h"
#include "traj/record/report_record.h"
#include "traj/record/tube_record.h"

namespace traj {

struct RestsOn {
  // The autopilot's own return, which looks at no battery.
  struct Returns {
    std::string action;
    std::string autopilot;
    double height = 0;  // m above home
    std::optional<double> least_height = {};
  };

  std::string first = {};  // what is said before all else; may be empty
  bool exact = false;
  std::string autopilot = {};
  std::size_t assumed = 0;                               // parameters
  std::optional<std::array<double, 2>> navigation = {};  // m, across and up or down
  std::optional<std::array<double, 2>> tracking = {};
  std::optional<Returns> returns = {};
  std::optional<TubeClaim> tube = {};
  std::vector<std::string> not_measured = {};  // quantities
  std::vector<std::string> overridden = {};
};

RestsOn rests_on(const ReportRecord& report);

// Of an accepted report of skyway-check or skyway-fly. Throws InputError where a key that it needs
// has another type.
RestsOn read_rests_on(const geom::JsonFields& fields, std::string_view source, std::size_t line);

// In one line; empty where there is nothing to say.
std::string in_words(const RestsOn& rests);

}  // namespace traj
