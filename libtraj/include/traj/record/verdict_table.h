#pragma once

// Verdicts as text for people: a sentence for one record, a table for several.
//
// Example:
//   traj::VerdictTable table;
//   traj::ReportRecord report{.id = "q1", .checked = "trajectory"};
//   report.result = traj::check(scene, trajectory, limits);
//   table.add(report, map);
//   assert(table.text().starts_with("q1: proved: clear for "));

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geom/map/box_map.h"
#include "traj/record/moving_record.h"
#include "traj/record/pair_record.h"
#include "traj/record/report_record.h"
#include "traj/record/sampled_report.h"

namespace traj {

// Whether words are green and red, by the codes that terminals know.
enum class Colour { none, terminal };

class VerdictTable {
 public:
  void add(const ReportRecord& report, const geom::BoxMap& map);
  void add(const SampledReport& report, const geom::BoxMap& map);
  // Of the check together, and of that against obstacles that move: a sentence for each refusal,
  // and one for all.
  void add(const TogetherResult& result, const TogetherTask& task, std::size_t left_out);
  void add(std::span<const MovingConflict> conflicts, const MovingSummary& summary);

  // Lines that end with a newline; empty without a record.
  std::string text(Colour colour = Colour::none) const;

 private:
  struct Row {
    std::string id;
    std::string word;                 // "ok", or the reason; of an accepted log what was looked at
    std::string_view yes = "proved";  // in a sentence
    bool ok = false;
    std::optional<double> clearance;  // m
    std::optional<double> duration;   // s
    std::string sentence;
    std::string why;  // beside it in a table: what is wrong, or what a yes rests on
  };
  struct Line {
    bool ok = false;
    std::string text;
  };

  std::string table(Colour colour) const;
  std::string summary() const;

  std::vector<Row> rows_;
  std::vector<Line> lines_;  // below
};

}  // namespace traj
