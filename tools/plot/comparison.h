#pragma once

// Benchmark reports side by side.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geom/text/json_fields.h"

namespace plot {

struct MethodFigures {
  struct Spread {
    double median = 0;
    double mean = 0;
    double p99 = 0;
  };
  std::string method;
  std::size_t trials = 0;
  std::size_t found = 0;
  std::optional<Spread> time;  // ms; the mean alone where a whole process was timed
  std::optional<Spread> length_over_best;
  std::optional<Spread> length_over_straight;
};

struct Comparison {
  std::string name;  // of the queries
  std::vector<MethodFigures> methods;
};

// A report of skyway-bench. Throws InputError for anything else.
Comparison parse_comparison(const geom::JsonFields& report, std::string_view name);

// An SVG: a row a method and report, with the time on a logarithmic axis, the length ratio (over
// the best known where every method has that, else over the straight line), and how many were
// found.
std::string comparison(std::span<const Comparison> reports);

}  // namespace plot
