#pragma once

// What a planner tells of its search: for reports, not for decisions.
//
// Example:
//   const geom::SearchReport report{.method = "lattice", .expanded = 7067, .resolution = 0.3125};
//   std::cout << geom::json_of(report).line();

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geom/base/vec3.h"

namespace geom {

class JsonFields;
class JsonLine;

// What is left of a path after a step: "search", "shortcut", "taut", "bound", "resample", "layer".
struct PathStep {
  std::string name;
  std::size_t points = 0;
  double length = 0;  // metres

  friend bool operator==(const PathStep&, const PathStep&) = default;
};

struct SearchReport {
  std::string method;                   // which search gave the path, or was the last; may be empty
  std::optional<std::size_t> expanded;  // nodes, bends, cells, or iterations of sampling
  std::optional<double> resolution;     // metres between nodes of its lattice
  std::vector<PathStep> steps;          // from the search to the path
  std::optional<std::pair<double, double>> layer;  // heights it goes in between its ends
  std::optional<Vec3> snapped_start;               // where an end was moved to
  std::optional<Vec3> snapped_goal;

  friend bool operator==(const SearchReport&, const SearchReport&) = default;
};

// The members of the JSON object "search" of a path record.
JsonLine json_of(const SearchReport& report);

// The member "search" of a path record; nothing if there is none, or no object. Other planners
// write reports too: members that are not known, or have another type, are left out.
std::optional<SearchReport> read_search_report(const JsonFields& record);

}  // namespace geom
