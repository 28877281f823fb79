#pragma once

// A figure of benchmark reports side by side.
//
// Example:
//   const std::string json = R"({"type":"benchmark","methods":[{"method":"auto",)"
//       R"("trials":4,"found":3,"time_ms":{"mean":0.2,"p50":0.1,"p99":1}}]})";
//   const auto report = plan::bench::parse_report({json, "report.json", 0}, "city");
//   const std::string svg = plan::bench::compared_figure(std::span(&report, 1));
//   assert(svg.find("3 of 4") != std::string::npos);

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geom/text/json_fields.h"

namespace plan::bench {

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

struct ShownReport {
  std::string name;  // of the queries
  std::vector<MethodFigures> methods;
};

// A report of skyway-bench. Throws InputError for anything else.
ShownReport parse_report(const geom::JsonFields& report, std::string_view name);

// An SVG: a row a method and report, with the time on a logarithmic axis, the length ratio (over
// the best known where every method has that, else over the straight line), and how many were
// found.
std::string compared_figure(std::span<const ShownReport> reports);

}  // namespace plan::bench
