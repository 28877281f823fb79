#include "traj/record/junit_suite.h"

#include <fmt/format.h>

#include "geom/text/markup.h"
#include "traj/record/verdict.h"

namespace traj {

void JUnitSuite::add(const ReportRecord& report, const geom::BoxMap& map) {
  if (accepted(report)) return add_case(report.id, {}, {});
  if (report.dropped) return add_skipped(report.id, in_words(report, map));
  add_case(report.id, verdict_word(report), in_words(report, map));
}

void JUnitSuite::add(const TogetherResult& result, const TogetherTask& task, std::size_t left_out) {
  for (const RefusedPair& pair : result.refused) {
    add_case(task.ids[pair.flights.first] + " and " + task.ids[pair.flights.second],
             pair.result.undecided ? "undecided" : "separation", traj::in_words(pair, task));
  }
  if (left_out > 0) {
    add_case(
        "together", "left_out",
        fmt::format("{} of the flights have no trajectory to hold against the others", left_out));
  } else {
    add_case(fmt::format("together: the other {} pairs", result.pairs - result.refused.size()), {},
             {});
  }
}

void JUnitSuite::add(std::span<const MovingConflict> conflicts, const MovingSummary& summary) {
  for (const MovingConflict& one : conflicts) {
    add_case(one.flight + " and " + one.obstacle, traj::reason_of(one), traj::in_words(one));
  }
  if (summary.left_out > 0) {
    add_case("moving", "left_out",
             fmt::format("{} of the flights have no trajectory to hold against obstacles",
                         summary.left_out));
  } else {
    add_case(fmt::format("moving: the other {} pairs of a flight and an obstacle",
                         summary.flights * summary.obstacles - conflicts.size()),
             {}, {});
  }
}

void JUnitSuite::add_case(const std::string& name, std::string_view failure,
                          const std::string& message) {
  ++tests_;
  cases_ += fmt::format("    <testcase classname=\"skyway-check\" name=\"{}\"",
                        geom::escaped_markup(name));
  if (failure.empty()) {
    cases_ += "/>\n";
    return;
  }
  ++failures_;
  cases_ += fmt::format(">\n      <failure type=\"{}\" message=\"{}\"/>\n    </testcase>\n",
                        failure, geom::escaped_markup(message));
}

void JUnitSuite::add_skipped(const std::string& name, const std::string& message) {
  ++tests_;
  ++skipped_;
  cases_ += fmt::format(
      "    <testcase classname=\"skyway-check\" name=\"{}\">\n      <skipped message=\"{}\"/>\n    "
      "</testcase>\n",
      geom::escaped_markup(name), geom::escaped_markup(message));
}

std::string JUnitSuite::xml() const {
  const std::string skipped = skipped_ > 0 ? fmt::format(" skipped=\"{}\"", skipped_) : "";
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n  <testsuite "
      "name=\"skyway-check\" tests=\"{0}\" failures=\"{1}\"{3}>\n{2}  "
      "</testsuite>\n</testsuites>\n",
      tests_, failures_, cases_, skipped);
}

}  // namespace traj
