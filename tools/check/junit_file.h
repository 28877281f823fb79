#pragma once

// --junit of skyway-check: what was found, for continuous integration.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "cli/file/files.h"
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
  void commit();

 private:
  std::string file_;
  std::optional<cli::OutputFile> out_;
  std::string cases_;
  std::size_t tests_ = 0;
  std::size_t failures_ = 0;
};

}  // namespace checking
