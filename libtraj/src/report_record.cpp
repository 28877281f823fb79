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

void append_jumps(std::string& out, const CheckResult& result) {
  out += ",\"jumps\":[";
  for (const double jump : result.jumps) {
    geom::append_json(out, jump);
    out += ',';
  }
  out.back() = ']';
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

std::size_t pieces(const ExactResult& exact) {
  std::size_t count = 0;
  for (const SegmentProof& proof : exact.segments) {
    for (const Cover* cover :
         {&proof.clear.pieces, &proof.bounds, &proof.speed, &proof.acceleration, &proof.jerk,
          &proof.tilt, &proof.horizontal_speed, &proof.vertical_speed, &proof.thrust,
          &proof.body_rate, &proof.yaw_rate}) {
      count += cover->size();
    }
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
    geom::append_json(out, std::string_view(exact.reason));
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
    geom::append_json(line, std::string_view(result.reason));
  } else if (!result.ok) {
    append_violation(line, result, map);
  } else if (!accepted(record)) {  // never, unless one of the two checks is wrong
    line += ",\"reason\":\"exact\"";
  }
  line += ",\"checked\":";
  geom::append_json(line, std::string_view(record.checked));
  if (result.clearance) append_extreme(line, "clearance", *result.clearance);
  if (result.duration > 0) {
    append_number(line, "duration", result.duration);
    append_extreme(line, "speed", result.speed);
    append_extreme(line, "acceleration", result.acceleration);
    append_extreme(line, "jerk", result.jerk);
    append_extreme(line, "tilt", result.tilt);
    append_extreme(line, "horizontal_speed", result.horizontal_speed);
    append_extreme(line, "vertical_speed", result.vertical_speed);
    append_extreme(line, "thrust", result.thrust);
    append_extreme(line, "body_rate", result.body_rate);
    append_extreme(line, "yaw_rate", result.yaw_rate);
    append_jumps(line, result);
  }
  if (record.exact) append_exact(line, record, map);
  line += ',';
  geom::append_json(line, record.provenance);
  append_json(line, record.limits);
  line.back() = '}';  // the comma that each part leaves behind it
  line += '\n';
  return line;
}

}  // namespace traj
