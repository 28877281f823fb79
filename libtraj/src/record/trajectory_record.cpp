#include "traj/record/trajectory_record.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "geom/text/json_fields.h"
#include "traj/proof/domain.h"

namespace traj {
namespace {

using geom::JsonFields;
using Json = nlohmann::json;

template <class Values>
void append_values(std::string& out, const char* key, const Values& value_of) {
  out += key;
  for (int i = 0; i < kPoints; ++i) {
    if (i) out += ',';
    geom::append_json(out, value_of(i));
  }
  out += ']';
}

void append_segment(std::string& out, const Segment& s) {
  out += "{\"duration\":";
  geom::append_json(out, s.duration);
  append_values(out, ",\"x\":[", [&](int i) { return s.point[i].x(); });
  append_values(out, ",\"y\":[", [&](int i) { return s.point[i].y(); });
  append_values(out, ",\"z\":[", [&](int i) { return s.point[i].z(); });
  if (s.yaw) append_values(out, ",\"yaw\":[", [&](int i) { return (*s.yaw)[i]; });
  out += '}';
}

std::array<double, kPoints> parse_values(const JsonFields& fields, const Json& segment,
                                         const char* key, std::string_view where) {
  const std::string what = fmt::format("{}.{}", where, key);
  if (!segment.contains(key) || !segment[key].is_array() || segment[key].size() != kPoints) {
    fields.refuse(fmt::format("{} must be a list of 8 numbers, found {}", what,
                              segment.contains(key) ? segment[key].dump() : "none"));
  }
  std::array<double, kPoints> values;
  for (int i = 0; i < kPoints; ++i) {
    values[i] = fields.number(segment[key][i], what);
    if (std::abs(values[i]) > geom::kLargestCoordinate) {
      fields.refuse(fmt::format("{} must be within 1e8, found {}", what, segment[key][i].dump()));
    }
  }
  return values;
}

Segment parse_segment(const JsonFields& fields, const Json& segment, std::size_t index) {
  const std::string where = fmt::format("segments[{}]", index);
  if (!segment.is_object()) {
    fields.refuse(fmt::format("{} must be an object, found {}", where, segment.dump()));
  }
  Segment s;
  const Json duration = segment.value("duration", Json());
  s.duration = fields.number(duration, where + ".duration");
  if (!(s.duration >= kShortestSegment && s.duration <= kLongestTrajectory)) {
    fields.refuse(fmt::format("{}.duration must be within {} and {} s, found {}", where,
                              kShortestSegment, kLongestTrajectory, duration.dump()));
  }
  const char* axes[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    const auto values = parse_values(fields, segment, axes[axis], where);
    for (int i = 0; i < kPoints; ++i) s.point[i][axis] = values[i];
  }
  if (segment.contains("yaw")) s.yaw = parse_values(fields, segment, "yaw", where);
  return s;
}

}  // namespace

Limits limits_of(const TrajectoryRecord& record) {
  const auto& vehicle = record.provenance.vehicle;
  return geom::limits_that_hold({{}, record.limits, vehicle ? vehicle->limits : Limits{}});
}

std::string to_json_line(const TrajectoryRecord& record) {
  std::string line = "{\"type\":\"trajectory\",\"id\":";
  geom::append_json(line, std::string_view(record.id));
  line += ",\"status\":";
  geom::append_json(line, name(record.status));
  line += ',';
  if (!record.trajectory.segments.empty()) {
    line += "\"duration\":";
    geom::append_json(line, duration(record.trajectory));
    line += ',';
  }
  if (record.rung) {
    line += "\"rung\":";
    geom::append_json(line, name(*record.rung));
    line += ',';
  }
  geom::append_json(line, record.provenance);
  geom::append_json(line, record.limits);
  if (!record.message.empty()) {
    line += "\"message\":";
    geom::append_json(line, std::string_view(record.message));
    line += ',';
  }
  if (!record.solver.empty()) line += "\"solver\":" + record.solver + ',';
  line += "\"segments\":[";
  for (std::size_t i = 0; i < record.trajectory.segments.size(); ++i) {
    if (i) line += ',';
    append_segment(line, record.trajectory.segments[i]);
  }
  line += "]}\n";
  return line;
}

TrajectoryRecord parse_trajectory_record(std::string_view json, std::string_view source,
                                         std::size_t line) {
  const JsonFields fields(json, source, line);
  fields.require_type("trajectory");
  TrajectoryRecord record;
  record.id = fields.text("id");
  record.status = fields.word("status", kTrajectoryStatusWords, TrajectoryStatus::solved);
  record.provenance = fields.provenance();
  record.limits = fields.limits();
  record.message = fields.text("message", "");
  if (fields.has("rung")) record.rung = fields.word("rung", kRungWords, Rung::closed);
  if (fields.has("solver")) record.solver = fields.value("solver").dump();
  if (fields.has("segments")) {
    const Json& list = fields.value("segments");
    if (!list.is_array()) fields.refuse("segments must be a list, found " + list.dump());
    for (std::size_t i = 0; i < list.size(); ++i) {
      record.trajectory.segments.push_back(parse_segment(fields, list[i], i));
    }
  }
  if (duration(record.trajectory) > kLongestTrajectory) {
    fields.refuse(fmt::format("the segments must last at most {} s in all, found {} s",
                              kLongestTrajectory, duration(record.trajectory)));
  }
  if (record.status == TrajectoryStatus::solved && record.trajectory.segments.empty()) {
    fields.refuse("segments must not be empty when the status is solved, found none");
  }
  return record;
}

}  // namespace traj
