#include "traj/record/sampled_report.h"

#include <tuple>

#include "geom/text/json_line.h"
#include "traj/record/report_record.h"

namespace traj {
namespace {

using geom::JsonLine;

JsonLine plan_of(const SampledReport& report) {
  const FlownTube& plan = *report.plan;
  JsonLine line;
  line.add("furthest", plan.furthest.value).add("furthest_time", plan.furthest.time);
  if (!report.tube) return line;
  line.add("tube", geom::word_of(kTubeKindWords, *report.tube)).add("inside_tube", plan.inside);
  line.add("share", static_cast<double>(plan.inside) / static_cast<double>(report.samples));
  if (plan.inside < report.samples) line.add("left_tube", plan.left);
  return line;
}

}  // namespace

std::string_view reason_of(const SampledReport& report, const geom::BoxMap& map) {
  const SampledFlight& result = report.result;
  const std::string_view found = verdict(result);
  const std::optional<double>& asked = report.rule.clearance;
  if (found != "sampled") return found;
  if (!asked && !report.rule.sampled) return "sampled";
  if (!report.map_said && !report.rule.any_map) return "no_map";
  if (report.cut || report.short_of_plan) return "cut";
  if (!asked || map.size() == 0) return "";
  if (!result.clearance) return "clearance_not_measured";
  return result.clearance->value >= *asked ? "" : "clearance";
}

std::string to_json_line(const SampledReport& report, const geom::BoxMap& map) {
  const SampledFlight& result = report.result;
  const std::string_view reason = reason_of(report, map);
  JsonLine line;
  line.add("type", "report").add("id", report.id).add("ok", reason.empty());
  if (!reason.empty()) line.add("reason", reason);
  if (verdict(result) != "sampled") {
    line.add("time", result.time).add("place", result.place).add("worst", result.worst);
    if (result.box) line.add("box", map.ids()[*result.box]);
  } else if (reason == "clearance") {
    line.add("time", result.clearance->time).add("place", result.nearest);
    line.add("worst", result.clearance->value);
  } else if (reason.empty() && report.rule.clearance) {
    line.add("verdict", "clearance");
  } else if (reason.empty() || reason == "sampled") {
    line.add("verdict", "sampled");
  }
  line.add("checked", kCheckedFlightLog);
  if (!report.checked_hash.empty()) line.add("checked_hash", report.checked_hash);
  line.add("required_clearance", report.rule.clearance);
  if (result.clearance) {
    line.add("clearance", result.clearance->value).add("clearance_time", result.clearance->time);
    line.add("nearest", result.nearest);
  }
  if (result.duration > 0) line.add("duration", result.duration);
  if (result.on_ground > 0) line.add("on_ground", result.on_ground);
  line.add("samples", report.samples).add("longest_step", result.longest_step);
  if (report.cut) line.add("cut", true);
  if (report.plan) line.add("plan", plan_of(report));
  add(line, report.provenance);
  if (reason.empty() && !report.map_said) line.add("overridden", std::tuple("map"));
  return line.line();
}

}  // namespace traj
