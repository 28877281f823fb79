#pragma once

// --junit of skyway-check: what was found, for continuous integration.

#include <CLI/CLI.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "cli/file/files.h"
#include "traj/record/moving_record.h"
#include "traj/record/pair_record.h"
#include "traj/record/report_record.h"

namespace checking {

// A test suite in the XML that JUnit's report writer made common: a test case a record, its
// failure with the reason, and where.
class JUnitFile {
 public:
  void add_to(CLI::App& app);
  const std::string& file() const { return file_; }  // empty: not asked for

  void open();
  void add(const traj::ReportRecord& report, const geom::BoxMap& map);
  // Of the check together: a case for all pairs that passed, and one for each that failed.
  void add(const traj::TogetherResult& result, const traj::TogetherTask& task,
           std::size_t left_out);
  // Of the check against obstacles that move, alike.
  void add(std::span<const traj::MovingConflict> conflicts, const traj::MovingSummary& summary);
  void commit();

 private:
  // Passed where there is no failure.
  void add_case(const std::string& name, std::string_view failure, const std::string& message);

  std::string file_;
  std::optional<cli::OutputFile> out_;
  std::string cases_;
  std::size_t tests_ = 0;
  std::size_t failures_ = 0;
};

}  // namespace checking
