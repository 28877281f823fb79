#pragma once

// -o and --report of skyway-check: where reports go, and whether they are for people.

#include <CLI/CLI.hpp>
#include <string>

#include "traj/record/verdict_table.h"

namespace checking {

class ReportOutput {
 public:
  void add_to(CLI::App& app);
  const std::string& file() const { return file_; }

  // A sentence or a table, in place of records: as --report says, else on a terminal.
  bool is_text() const;
  bool asks_for_text() const { return form_ == "text"; }
  // Of that text.
  traj::Colour colour() const;
  // Whether stderr says what failed: not where the text says it at the same place.
  bool tells() const { return !(is_text() && file_ == "-"); }

 private:
  const CLI::App* app_ = nullptr;
  std::string file_ = "-";
  std::string form_;
};

}  // namespace checking
