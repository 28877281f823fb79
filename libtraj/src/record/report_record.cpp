#include "traj/record/report_record.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "geom/text/json_fields.h"
#include "json_number.h"
#include "traj/record/certificate_record.h"
#include "traj/record/trajectory_record.h"

namespace traj {
namespace {

// Nothing of what was not measured.
void append_extreme(std::string& out, std::string_view key, const std::optional<Extreme>& extreme) {
  if (!extreme) return;
  append_number(out, key, extreme->value);
  append_number(out, std::string(key) + "_time", extreme->time);
}

void append_jumps(std::string& out, const CheckResult& result) {
  if (!result.jumps) return;
  out += ",\"jumps\":[";
  for (const double jump : *result.jumps) {
    geom::append_json(out, jump);
    out += ',';
  }
  out.back() = ']';
}

void append_not_measured(std::string& out, const ReportRecord& record) {
  const std::vector<Limit> missing = not_measured(record.result, record.limits);
  if (missing.empty()) return;
  out += ",\"not_measured\":[";
  for (const Limit limit : missing) {
    geom::append_json(out, std::string_view(kind_of(limit).quantity));
    out += ',';
  }
  out.back() = ']';
}

void append_violation(std::string& out, const CheckResult& result, const geom::BoxMap& map) {
  out += ",\"reason\":";
  geom::append_json(out, name(result.reason));
  append_number(out, "time", result.time);
  out += ",\"place\":";
  geom::append_json(out, result.place);
  append_number(out, "worst", result.worst);
  if (result.box) out += ",\"box\":" + std::to_string(map.ids()[*result.box]);
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

void append_exact(std::string& out, const ReportRecord& record, const geom::BoxMap& map) {
  const ExactResult& exact = *record.exact;
  out += ",\"exact\":{\"ok\":";
  out += exact.ok ? "true" : "false";
  if (!exact.ok) {
    out += ",\"reason\":";
    geom::append_json(out, name(exact.reason));
    if (exact.undecided) out += ",\"undecided\":true";
    append_number(out, "time", exact.time);
    out += ",\"place\":";
    geom::append_json(out, exact.place);
    if (exact.box) out += ",\"box\":" + std::to_string(map.ids()[*exact.box]);
  }
  out += ",\"pieces\":" + std::to_string(pieces(exact));
  if (record.checked == "trajectory") {
    const char* names[] = {"position", "velocity", "acceleration", "jerk"};
    out += ",\"joints\":{";
    for (std::size_t i = 0; i < exact.joints.size(); ++i) {
      out += std::string(i ? ",\"" : "\"") + names[i] + "\":";
      geom::append_json(out, std::string_view(exact.joints[i]));
    }
    out += '}';
  }
  out += '}';
}

bool flag(const geom::JsonFields& fields, const nlohmann::json& object, const std::string& what) {
  if (!object.contains("ok") || !object["ok"].is_boolean()) {
    fields.refuse(fmt::format("{} must be true or false, found {}", what,
                              object.contains("ok") ? object["ok"].dump() : "none"));
  }
  return object["ok"].get<bool>();
}

std::optional<std::uint64_t> parse_box(const geom::JsonFields& fields) {
  if (!fields.has("box")) return std::nullopt;
  const nlohmann::json& box = fields.value("box");
  if (!box.is_number_unsigned()) {
    fields.refuse("box must be a whole number >= 0, found " + box.dump());
  }
  return box.get<std::uint64_t>();
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

}  // namespace

bool accepted(const ReportRecord& record) {
  return record.result.ok && (!record.exact || record.exact->ok);
}

std::string to_json_line(const ReportRecord& record, const geom::BoxMap& map) {
  const CheckResult& result = record.result;
  std::string line = "{\"type\":\"report\",\"id\":";
  geom::append_json(line, std::string_view(record.id));
  line += accepted(record) ? ",\"ok\":true" : ",\"ok\":false";
  if (!result.ok && !result.clearance && result.duration == 0) {
    line += ",\"reason\":";
    geom::append_json(line, name(result.reason));
  } else if (!result.ok) {
    append_violation(line, result, map);
  } else if (!accepted(record)) {  // never, unless one of the two checks is wrong
    line += ",\"reason\":\"exact\"";
  }
  line += ",\"checked\":";
  geom::append_json(line, std::string_view(record.checked));
  append_extreme(line, "clearance", result.clearance);
  if (result.duration > 0) append_number(line, "duration", result.duration);
  for (const Limit limit : kOrderOfLimits) {
    append_extreme(line, kind_of(limit).quantity, result.largest[limit]);
  }
  append_jumps(line, result);
  append_not_measured(line, record);
  if (record.exact) append_exact(line, record, map);
  line += ',';
  geom::append_json(line, record.provenance);
  geom::append_json(line, record.limits);
  append_overridden(line, record.overridden);
  line.back() = '}';  // the comma that each part leaves behind it
  line += '\n';
  return line;
}

ReportSummary parse_report_record(std::string_view json, std::string_view source,
                                  std::size_t line) {
  const geom::JsonFields fields(json, source, line);
  const bool flown = fields.text("type", "") == "flight";
  if (!flown) fields.require_type("report");
  ReportSummary report;
  report.id = fields.text("id");
  report.checked = flown ? "flight" : fields.text("checked", "");
  report.ok = flag(fields, fields.object(), "ok");
  if (!report.ok) report.reason = fields.text("reason");
  report.time = fields.number("time");
  if (fields.has("place")) report.place = fields.point("place");
  report.worst = fields.number("worst");
  report.box = parse_box(fields);
  report.duration = fields.number("duration");
  report.extremes = parse_extremes(fields);
  if (fields.has("exact")) {
    const nlohmann::json& exact = fields.value("exact");
    if (!exact.is_object()) fields.refuse("exact must be an object, found " + exact.dump());
    report.exact_ok = flag(fields, exact, "exact.ok");
  }
  report.provenance = fields.provenance();
  report.limits = fields.limits();
  return report;
}

}  // namespace traj
