#pragma once

// Verdicts as a JUnit test suite, for continuous integration.
//
// Example:
//   traj::JUnitSuite suite;
//   suite.add(traj::TogetherResult{}, traj::TogetherTask{}, 0);
//   assert(suite.xml().starts_with("<?xml"));

#include <span>
#include <string>
#include <string_view>

#include "geom/map/box_map.h"
#include "traj/record/moving_record.h"
#include "traj/record/pair_record.h"
#include "traj/record/report_record.h"

namespace traj {

// A test suite in the XML that JUnit's report writer made common: a test case a record, its
// failure with the reason, and where.
class JUnitSuite {
 public:
  // One that was dropped is skipped.
  void add(const ReportRecord& report, const geom::BoxMap& map);
  // Of the check together: a case for all pairs that passed, and one for each that failed.
  void add(const TogetherResult& result, const TogetherTask& task, std::size_t left_out);
  // Of the check against obstacles that move, alike.
  void add(std::span<const MovingConflict> conflicts, const MovingSummary& summary);

  std::string xml() const;

 private:
  // Passed where there is no failure.
  void add_case(const std::string& name, std::string_view failure, const std::string& message);
  void add_skipped(const std::string& name, const std::string& message);

  std::string cases_;
  std::size_t tests_ = 0;
  std::size_t failures_ = 0;
  std::size_t skipped_ = 0;
};

}  // namespace traj
