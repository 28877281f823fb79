#include "traj/io/report_record.h"

#include "traj/io/trajectory_record.h"

namespace traj {
namespace {

void append_number(std::string& out, std::string_view key, double value) {
  out += ",\"";
  out += key;
  out += "\":";
  geom::append_json(out, value);
}

void append_extreme(std::string& out, std::string_view key, const Extreme& extreme) {
  append_number(out, key, extreme.value);
  append_number(out, std::string(key) + "_time", extreme.time);
}

void append_violation(std::string& out, const CheckResult& result, const geom::BoxMap& map) {
  out += ",\"reason\":";
  geom::append_json(out, std::string_view(result.reason));
  append_number(out, "time", result.time);
  out += ",\"place\":";
  geom::append_json(out, result.place);
  append_number(out, "worst", result.worst);
  if (result.box) out += ",\"box\":" + std::to_string(map.ids()[*result.box]);
}

}  // namespace

std::string to_json_line(const ReportRecord& record, const geom::BoxMap& map) {
  const CheckResult& result = record.result;
  std::string line = "{\"type\":\"report\",\"id\":";
  geom::append_json(line, std::string_view(record.id));
  line += result.ok ? ",\"ok\":true" : ",\"ok\":false";
  if (!result.ok && !result.clearance && result.duration == 0) {
    line += ",\"reason\":";
    geom::append_json(line, std::string_view(result.reason));
  } else if (!result.ok) {
    append_violation(line, result, map);
  }
  line += ",\"checked\":";
  geom::append_json(line, std::string_view(record.checked));
  if (result.clearance) append_extreme(line, "clearance", *result.clearance);
  if (result.duration > 0) {
    append_number(line, "duration", result.duration);
    append_extreme(line, "speed", result.speed);
    append_extreme(line, "acceleration", result.acceleration);
    append_extreme(line, "jerk", result.jerk);
    if (record.limits.tilt) append_extreme(line, "tilt", result.tilt);
    if (record.limits.vmax_h) append_extreme(line, "horizontal_speed", result.horizontal_speed);
    if (record.limits.vmax_v) append_extreme(line, "vertical_speed", result.vertical_speed);
    if (record.limits.thrust) append_extreme(line, "thrust", result.thrust);
  }
  line += ',';
  geom::append_json(line, record.provenance);
  append_json(line, record.limits);
  line.back() = '}';  // the comma that each part leaves behind it
  line += '\n';
  return line;
}

}  // namespace traj
