#include "traj/record/junit_suite.h"

#include <fmt/format.h>

#include "geom/text/markup.h"

namespace traj {
namespace {

// "collision, 0.413 m, box 7, item 3 (corner), near [1.000, 2.000, 3.000]".
std::string failure_of(const ReportRecord& report, const geom::BoxMap& map) {
  const CheckResult& result = report.result;
  if (result.ok) return "the exact check refuses what the other accepts";
  std::string words(name(result.reason));
  if (!result.looked) return words;
  words += fmt::format(", {:.4g}", result.worst);
  if (result.box) words += fmt::format(", box {}", map.ids()[*result.box]);
  if (result.part) {
    words += fmt::format(", item {} ({})", result.part->item, name(result.part->manoeuvre));
  }
  const geom::Vec3& p = result.place;
  words += fmt::format(", near [{:.3f}, {:.3f}, {:.3f}]", p.x(), p.y(), p.z());
  if (!report.detail.empty()) words += ": " + report.detail;
  return words;
}

}  // namespace

void JUnitSuite::add(const ReportRecord& report, const geom::BoxMap& map) {
  if (accepted(report)) return add_case(report.id, {}, {});
  add_case(report.id, name(report.result.reason), failure_of(report, map));
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

std::string JUnitSuite::xml() const {
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n  <testsuite "
      "name=\"skyway-check\" tests=\"{0}\" failures=\"{1}\">\n{2}  </testsuite>\n</testsuites>\n",
      tests_, failures_, cases_);
}

}  // namespace traj
