#include "traj/record/report_record.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "geom/text/json_fields.h"
#include "geom/text/json_line.h"
#include "geom/zone/zone_report.h"
#include "record/rests_on.h"
#include "traj/record/checked_hash.h"
#include "traj/record/duration_bound.h"

namespace traj {
namespace {

using geom::JsonLine;

constexpr double kSameDuration = 1e-9;  // rounding, of a duration

// Nothing of what was not measured.
void add_extreme(JsonLine& line, const std::string& key, const std::optional<Extreme>& extreme) {
  if (extreme) line.add(key, extreme->value).add(key + "_time", extreme->time);
}

void add_not_measured(JsonLine& line, const ReportRecord& record) {
  const std::vector<Limit> missing = not_measured(record.result, record.limits);
  if (missing.empty()) return;
  line.add("not_measured", missing, [](Limit limit) { return kind_of(limit).quantity; });
}

void add_box(JsonLine& line, std::optional<std::size_t> box, const geom::BoxMap& map) {
  if (box) line.add("box", map.ids()[*box]);
}

void add_violation(JsonLine& line, const CheckResult& result, const geom::BoxMap& map) {
  line.add("reason", name(result.reason)).add("time", result.time).add("place", result.place);
  line.add("worst", result.worst);
  add_box(line, result.box, map);
  if (result.part) line.add("item", result.part->item).add("part", name(result.part->manoeuvre));
  if (!result.strayed.empty()) line.add("strayed", result.strayed);
}

// Why a report refuses.
void add_reason(JsonLine& line, const ReportRecord& record, const geom::BoxMap& map) {
  const CheckResult& result = record.result;
  if (!result.ok && !result.looked) {
    line.add("reason", name(result.reason));
  } else if (!result.ok) {
    add_violation(line, result, map);
  } else if (record.exact && !record.exact->ok) {  // never, unless one of the checks is wrong
    line.add("reason", "exact");
  } else if (record.returns && !record.returns->ok()) {
    line.add("reason", name(Reason::return_home));
  } else if (!accepted(record)) {
    const FlightPathCheck& tube = record.tube->check;
    line.add("reason", kTubeReason).add("time", tube.time).add("place", tube.place);
    add_box(line, tube.box, map);
  }
}

std::size_t pieces(const ExactResult& exact) {
  std::size_t count = 0;
  for (const SegmentProof& proof : exact.segments) {
    count += proof.clear.pieces.size() + proof.bounds.size();
    for (const Cover& cover : proof.limits.values) count += cover.size();
    if (proof.gap) count += proof.gap->pieces.size();
  }
  return count;
}

JsonLine joints(const ExactResult& exact) {
  constexpr std::array kNames = {"position", "velocity", "acceleration", "jerk"};
  JsonLine line;
  for (std::size_t i = 0; i < kNames.size(); ++i) line.add(kNames[i], exact.joints[i]);
  return line;
}

JsonLine object_of(const ExactResult& exact, const ReportRecord& record, const geom::BoxMap& map) {
  JsonLine line;
  line.add("ok", exact.ok);
  if (!exact.ok) {
    line.add("reason", name(exact.reason));
    if (exact.undecided) line.add("undecided", true);
    line.add("time", exact.time).add("place", exact.place);
    add_box(line, exact.box, map);
  }
  if (record.checked != kCheckedContingency) line.add("pieces", pieces(exact));
  if (record.checked == "trajectory") line.add("joints", joints(exact));
  return line;
}

JsonLine object_of(const ReturnGap& gap, const geom::BoxMap& map) {
  JsonLine line;
  line.add("from", gap.from).add("until", gap.until);
  if (gap.part) line.add("item", gap.part->item).add("part", name(gap.part->manoeuvre));
  line.add("autopilot", gap.autopilot).add("phase", gap.phase).add("reason", name(gap.reason));
  line.add("at", gap.place);
  add_box(line, gap.box, map);
  if (gap.fence) line.add("fence", *gap.fence);
  return line;
}

JsonLine object_of(const ReturnReport& returns, const geom::BoxMap& map) {
  JsonLine line;
  line.add("action", returns.action).add("autopilot", returns.autopilot);
  line.add("home", returns.home).add("height", returns.height);
  line.add("share", returns.share()).add("duration", returns.duration);
  line.add("longest", returns.longest);
  line.add("gaps", returns.gaps, [&](const ReturnGap& gap) { return object_of(gap, map); });
  if (!returns.timeline.empty()) {
    line.add("timeline", returns.timeline, [](const TimedPlace& one) {
      return std::move(JsonLine().add("time", one.time).add("at", one.place));
    });
  }
  line.add("least_height", returns.least_height);
  line.add("best_height", returns.best_height).add("best_share", returns.best_share);
  return line;
}

JsonLine object_of(const TerrainClaim& terrain) {
  JsonLine line;
  add(line, terrain);
  return line;
}

JsonLine object_of(const TubeReport& tube) {
  JsonLine line;
  add(line, tube.claim);
  line.add("margin", tube.margin).add("clear", tube.check.clear);
  if (!tube.check.clear) line.add("reason", name(tube.check.reason));
  return line;
}

bool flag(const geom::JsonFields& fields, const nlohmann::json& object, const std::string& what) {
  if (!object.contains("ok") || !object["ok"].is_boolean()) {
    fields.refuse({.key = what,
                   .expected = "true or false",
                   .found = object.contains("ok") ? object["ok"].dump() : "none"});
  }
  return object["ok"].get<bool>();
}

std::optional<std::uint64_t> parse_count(const geom::JsonFields& fields, const char* key) {
  if (!fields.has(key)) return std::nullopt;
  const nlohmann::json& value = fields.value(key);
  if (!value.is_number_unsigned()) {
    fields.refuse({.key = key, .expected = "a whole number >= 0", .found = value.dump()});
  }
  return value.get<std::uint64_t>();
}

geom::Fault of_another(const ReportSummary& report, std::string_view why) {
  return {
      .expected = fmt::format("a report of the {} {}", report.checked, geom::in_quotes(report.id)),
      .found = fmt::format("one of another: {}", why),
      .advice = "check it anew with skyway-check"};
}

template <class Record>
bool has_other_numbers(const ReportSummary& report, const Record& record) {
  return !report.checked_hash.empty() && report.checked_hash != checked_hash(record);
}

std::vector<ReportSummary::Named> parse_extremes(const geom::JsonFields& fields) {
  std::vector<ReportSummary::Named> out;
  std::vector<const char*> names{"clearance"};
  for (const Limit limit : kOrderOfLimits) names.push_back(kind_of(limit).quantity);
  names.insert(names.end(), {"rms", "p99", "max", "final"});
  for (const char* name : names) {
    const auto value = fields.number(name);
    const auto time = fields.number((std::string(name) + "_time").c_str());
    if (value) out.push_back({name, *value, time});
  }
  return out;
}

void refuse(Reason reason, const Vec3& place, double worst, CheckResult& result) {
  result.ok = false;
  result.reason = reason;
  result.time = 0;
  result.place = place;
  result.worst = worst;
}

}  // namespace

void add_bounds(const TrajectoryRecord& record, ReportRecord& report) {
  if (!accepted(report) || !report.overridden.empty()) return;
  if (claims_too_much(record, report.limits)) {
    refuse(Reason::duration_bound, record.trajectory.segments.front().point.front(),
           record.duration_bound.value_or(0), report.result);
    return;
  }
  if (geom::mismatch(record.provenance, report.provenance)) return;
  report.claimed_bound = record.bound;
  report.duration_bound = duration_bound(record, report.limits);
}

void add_bounds(const geom::PathRecord& record, ReportRecord& report) {
  if (!accepted(report) || !report.overridden.empty() || !claims_too_much(record)) return;
  refuse(Reason::duration_bound, record.points.front(), *record.bound, report.result);
}

void refuse_unmeasured(const Limits& asked, const Vec3& place, ReportRecord& report) {
  const std::vector<Limit> missing = not_measured(report.result, asked);
  if (missing.empty() || !report.result.ok) return;
  refuse(unmeasured(missing.front()), place, 0, report.result);
}

namespace {

// The files of zones that were closed in the map, with their dates and hashes.
void add_airspace(JsonLine& line, const geom::BoxMapSpec& spec) {
  if (spec.history.find("\"zones\"") == std::string::npos) return;
  nlohmann::ordered_json files = nlohmann::ordered_json::array();
  for (const geom::ZoneSource& source : geom::zone_sources(spec)) {
    nlohmann::ordered_json file = {{"file", source.file}, {"hash", source.hash}};
    if (!source.issued.empty()) file["issued"] = source.issued;
    files.push_back(file);
  }
  if (!files.empty()) line.add_json("airspace", files.dump());
}

}  // namespace

bool accepted(const ReportRecord& record) {
  return record.result.ok && (!record.exact || record.exact->ok) &&
         (!record.returns || record.returns->ok()) && (!record.tube || record.tube->check.clear);
}

std::string to_json_line(const ReportRecord& record, const geom::BoxMap& map) {
  const CheckResult& result = record.result;
  JsonLine line;
  line.add("type", "report").add("id", record.id).add("ok", accepted(record));
  add_reason(line, record, map);
  if (record.dropped) line.add("dropped", true);
  line.add("checked", record.checked);
  if (!record.checked_hash.empty()) line.add("checked_hash", record.checked_hash);
  if (!record.detail.empty()) line.add("detail", record.detail);
  line.add("home", record.home);
  if (record.idle_items) line.add("idle_items", record.idle_items);
  if (record.endless_jumps) line.add("endless_jumps", record.endless_jumps);
  if (!record.autopilot.empty()) line.add("autopilot", record.autopilot);
  if (!record.assumed.empty()) line.add("assumed", record.assumed);
  line.add("drag", record.drag);
  if (record.terrain) line.add("terrain", object_of(*record.terrain));
  line.add("navigation", record.navigation).add("tracking", record.tracking);
  if (result.looked && !map.timed().empty()) {
    line.add("timed_boxes", record.by_time ? "by_time" : "always_there");
  }
  add_airspace(line, map.spec());
  add_extreme(line, "clearance", result.clearance);
  if (result.duration > 0) line.add("duration", result.duration);
  line.add("claimed_bound", record.claimed_bound).add("duration_bound", record.duration_bound);
  if (record.duration_bound) line.add("gap", result.duration / *record.duration_bound - 1);
  for (const Limit limit : kOrderOfLimits) {
    add_extreme(line, kind_of(limit).quantity, result.largest[limit]);
  }
  line.add("jumps", result.jumps);
  add_not_measured(line, record);
  if (record.exact) line.add("exact", object_of(*record.exact, record, map));
  if (record.returns) line.add("return", object_of(*record.returns, map));
  if (record.tube) line.add("tube", object_of(*record.tube));
  add(line, record.provenance);
  add(line, record.time);
  add(line, record.limits);
  if (!record.overridden.empty()) line.add("overridden", record.overridden);
  return line.line();
}

ReportSummary parse_report_record(std::string_view json, std::string_view source,
                                  std::size_t line) {
  const geom::JsonFields fields(json, source, line);
  const bool flown = fields.text("type", "") == "flight";
  if (!flown) fields.require_type("report");
  ReportSummary report;
  report.id = fields.text("id");
  report.checked = flown ? "flight" : fields.text("checked", "");
  report.checked_hash = fields.text("checked_hash", "");
  report.ok = flag(fields, fields.object(), "ok");
  if (!report.ok) report.reason = fields.text("reason");
  report.time = fields.number("time");
  if (fields.has("place")) report.place = fields.point("place");
  report.worst = fields.number("worst");
  report.box = parse_count(fields, "box");
  report.item = parse_count(fields, "item");
  report.part = fields.text("part", "");
  report.detail = fields.text("detail", "");
  report.duration = fields.number("duration");
  report.duration_bound = fields.number("duration_bound");
  report.extremes = parse_extremes(fields);
  if (fields.has("exact")) {
    const nlohmann::json& exact = fields.value("exact");
    if (!exact.is_object()) {
      fields.refuse({.key = "exact", .expected = "an object", .found = exact.dump()});
    }
    report.exact_ok = flag(fields, exact, "exact.ok");
  }
  if (fields.has("return")) {
    report.returns = parse_return_summary(fields.value("return").dump(), source, line);
    if (report.ok && !report.returns->ok()) {
      fields.refuse({.says = "ok is true beside times without a return"});
    }
  }
  report.provenance = geom::read_provenance(fields);
  report.limits = geom::read_limits(fields);
  report.start = geom::read_flight_time(fields);
  report.by_time = fields.text("timed_boxes", "") == "by_time";
  RestsOn rests = read_rests_on(fields, source, line);
  report.overridden = !rests.overridden.empty();
  if (const auto& r = report.returns) {
    rests.returns = {r->action, r->autopilot, r->height, r->least_height};
  }
  if (report.ok) report.rests_on = in_words(rests);
  return report;
}

std::optional<geom::Fault> why_not_of(const ReportSummary& report,
                                      const TrajectoryRecord& trajectory) {
  if (report.checked != "trajectory") return std::nullopt;
  const double lasts = duration(trajectory.trajectory);
  if (report.duration && !(std::abs(*report.duration - lasts) <= kSameDuration * lasts)) {
    return of_another(report, fmt::format("it lasts {:.6g} s, and the report is of one of {:.6g} s",
                                          lasts, *report.duration));
  }
  if (has_other_numbers(report, trajectory)) {
    return of_another(report, "its control points, durations or yaws are others");
  }
  const double starts = trajectory.time.starts();
  if (report.by_time && report.start.starts() != starts) {
    return of_another(
        report, fmt::format("it starts at {:.9g} s, and the report holds for a start at {:.9g} s",
                            starts, report.start.starts()));
  }
  return std::nullopt;
}

std::optional<geom::Fault> why_not_of(const ReportSummary& report, const geom::PathRecord& path) {
  if (report.checked != "path" || !has_other_numbers(report, path)) return std::nullopt;
  return of_another(report, "its points are others");
}

std::optional<geom::Fault> why_not_of(const ReportSummary& report, const FlightLog& log) {
  if (report.checked != kCheckedFlightLog || !has_other_numbers(report, log)) return std::nullopt;
  return of_another(report, "its samples are others");
}

}  // namespace traj
