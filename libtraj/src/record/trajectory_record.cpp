#include "traj/record/trajectory_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "geom/text/json_fields.h"
#include "geom/text/json_line.h"
#include "traj/proof/domain.h"

namespace traj {
namespace {

using geom::JsonFields;
using Json = nlohmann::json;

geom::JsonLine object_of(const Segment& s) {
  geom::JsonLine line;
  line.add("duration", s.duration);
  line.add("x", s.point, [](const Vec3& p) { return p.x(); });
  line.add("y", s.point, [](const Vec3& p) { return p.y(); });
  line.add("z", s.point, [](const Vec3& p) { return p.z(); });
  return line.add("yaw", s.yaw);
}

// With how much longer than it the flight takes.
void add_bounds(geom::JsonLine& line, const TrajectoryRecord& record) {
  line.add("bound", record.bound).add("duration_bound", record.duration_bound);
  if (record.duration_bound && *record.duration_bound > 0) {
    line.add("gap", duration(record.trajectory) / *record.duration_bound - 1);
  }
}

void read_bounds(const JsonFields& fields, TrajectoryRecord& record) {
  record.bound = fields.number("bound");
  record.duration_bound = fields.number("duration_bound");
  if (record.bound && *record.bound < 0) fields.refuse({.key = "bound", .expected = ">= 0"});
  if (record.duration_bound && *record.duration_bound < 0) {
    fields.refuse({.key = "duration_bound", .expected = ">= 0"});
  }
}

// Most values are right, so where they stand is said only of one that is refused.
std::array<double, kPoints> parse_values(const JsonFields& fields, const Json& segment,
                                         const char* key, std::size_t index) {
  const auto what = [&] { return fmt::format("segments[{}].{}", index, key); };
  const auto found = segment.find(key);
  if (found == segment.end() || !found->is_array() || found->size() != kPoints) {
    fields.refuse({.key = std::string(what()),
                   .expected = "a list of 8 numbers",
                   .found = found == segment.end() ? "none" : found->dump()});
  }
  std::array<double, kPoints> values;
  for (int i = 0; i < kPoints; ++i) {
    const Json& value = (*found)[static_cast<std::size_t>(i)];
    values[i] = value.is_number() ? value.get<double>() : fields.number(value, what());
    if (!(std::abs(values[i]) <= geom::kLargestCoordinate)) {
      fields.refuse({.key = std::string(what()), .expected = "within 1e8", .found = value.dump()});
    }
  }
  return values;
}

// A duration that is not that of its segments belongs to others, so nobody knows which of both is
// meant. Some programs write few digits.
void require_own_duration(const JsonFields& fields, const Trajectory& trajectory) {
  constexpr double kRounding = 0.005;  // s: two decimals
  constexpr double kShare = 1e-6;      // and six digits
  const auto said = fields.number("duration");
  if (!said || trajectory.segments.empty()) return;
  const double lasts = duration(trajectory);
  if (std::abs(*said - lasts) <= std::max(kRounding, kShare * lasts)) return;
  fields.refuse({.key = "duration",
                 .expected = fmt::format("{:.9g}, the sum of its segments", lasts),
                 .found = fmt::format("{:.9g}", *said),
                 .advice = "make the record anew, or leave this member out if the segments are "
                           "right"});
}

Segment parse_segment(const JsonFields& fields, const Json& segment, std::size_t index) {
  const auto where = [&] { return fmt::format("segments[{}]", index); };
  if (!segment.is_object()) {
    fields.refuse({.key = std::string(where()), .expected = "an object", .found = segment.dump()});
  }
  Segment s;
  const auto found = segment.find("duration");
  const Json& duration = found == segment.end() ? Json() : *found;
  s.duration = duration.is_number() ? duration.get<double>()
                                    : fields.number(duration, where() + ".duration");
  if (!(s.duration >= kShortestSegment && s.duration <= kLongestTrajectory)) {
    fields.refuse(
        {.key = fmt::format("{}.duration", where()),
         .expected = fmt::format("within {} and {} s", kShortestSegment, kLongestTrajectory),
         .found = duration.dump()});
  }
  const char* axes[] = {"x", "y", "z"};
  for (int axis = 0; axis < 3; ++axis) {
    const auto values = parse_values(fields, segment, axes[axis], index);
    for (int i = 0; i < kPoints; ++i) s.point[i][axis] = values[i];
  }
  if (segment.contains("yaw")) s.yaw = parse_values(fields, segment, "yaw", index);
  return s;
}

}  // namespace

Limits limits_of(const TrajectoryRecord& record) {
  const auto& vehicle = record.provenance.vehicle;
  return geom::limits_that_hold({{}, record.limits, vehicle ? vehicle->limits : Limits{}});
}

std::string to_json_line(const TrajectoryRecord& record) {
  geom::JsonLine line;
  line.add("type", "trajectory").add("id", record.id).add("status", name(record.status));
  const std::vector<Segment>& segments = record.trajectory.segments;
  if (!segments.empty()) line.add("duration", duration(record.trajectory));
  add_bounds(line, record);
  if (record.rung) line.add("rung", name(*record.rung));
  add(line, record.provenance);
  add(line, record.time);
  add(line, record.limits);
  if (!record.message.empty()) line.add("message", record.message);
  if (!record.solver.empty()) line.add_json("solver", record.solver);
  return line.add("segments", segments, object_of).line();
}

TrajectoryRecord parse_trajectory_record(std::string_view json, std::string_view source,
                                         std::size_t line) {
  return read_trajectory_record(JsonFields(json, source, line));
}

TrajectoryRecord read_trajectory_record(const JsonFields& fields) {
  fields.require_type("trajectory");
  TrajectoryRecord record;
  record.id = fields.text("id");
  record.status = fields.word("status", kTrajectoryStatusWords, TrajectoryStatus::solved);
  record.provenance = geom::read_provenance(fields);
  record.time = geom::read_flight_time(fields);
  record.limits = geom::read_limits(fields);
  record.message = fields.text("message", "");
  if (fields.has("rung")) record.rung = fields.word("rung", kRungWords, Rung::closed);
  if (fields.has("solver")) record.solver = fields.value("solver").dump();
  read_bounds(fields, record);
  if (fields.has("segments")) {
    const Json& list = fields.value("segments");
    if (!list.is_array())
      fields.refuse({.key = "segments", .expected = "a list", .found = list.dump()});
    for (std::size_t i = 0; i < list.size(); ++i) {
      record.trajectory.segments.push_back(parse_segment(fields, list[i], i));
    }
  }
  if (duration(record.trajectory) > kLongestTrajectory) {
    fields.refuse(
        {.says = fmt::format("the segments must last at most {} s in all", kLongestTrajectory),
         .found = fmt::format("{} s", duration(record.trajectory))});
  }
  require_own_duration(fields, record.trajectory);
  if (record.status == TrajectoryStatus::solved && record.trajectory.segments.empty()) {
    fields.refuse(
        {.says = "segments must not be empty when the status is solved", .found = "none"});
  }
  return record;
}

}  // namespace traj
