#include "geom/record/record.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "geom/base/error.h"
#include "geom/collision/collision.h"
#include "geom/text/json_fields.h"
#include "geom/text/parse_json.h"

namespace geom {
namespace {

void append_ranges(std::string& out, const char* key, const std::vector<LegRange>& ranges) {
  out += fmt::format("\"{}\":[", key);
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    out += fmt::format("{}[{},{}]", i ? "," : "", ranges[i].first, ranges[i].last);
  }
  out += "],";
}

}  // namespace

void append_json(std::string& out, double value) {
  if (!std::isfinite(value)) {
    out += "null";
    return;
  }
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  out.append(digits, end);
}

void append_json(std::string& out, std::string_view text) {
  // error_handler replace: a name that is not UTF-8 must not stop a report about it.
  out += nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void append_json(std::string& out, const Vec3& v) {
  out += '[';
  append_json(out, v[0]);
  out += ',';
  append_json(out, v[1]);
  out += ',';
  append_json(out, v[2]);
  out += ']';
}

void append_json(std::string& out, const Provenance& provenance) {
  if (provenance.map) {
    out += "\"map\":";
    append_json(out, std::string_view(*provenance.map));
    out += ',';
  }
  if (provenance.frame) {
    out += "\"frame\":";
    append_json(out, name(*provenance.frame));
    out += ',';
  }
  if (provenance.vehicle) {
    out += "\"vehicle\":{\"name\":";
    append_json(out, std::string_view(provenance.vehicle->name));
    out += ",\"half\":";
    append_json(out, provenance.vehicle->half);
    out += ',';
    append_json(out, provenance.vehicle->limits);
    out.back() = '}';  // the comma that each part leaves behind it
    out += ',';
  }
  if (provenance.margin) {
    out += "\"margin\":";
    append_json(out, *provenance.margin);
    out += ',';
  }
}

void append_json(std::string& out, const Limits& limits) {
  std::string body;
  for (const LimitKind& kind : kLimitKinds) {
    const auto& limit = limits[kind.limit];
    if (!limit) continue;
    body += fmt::format("{}\"{}\":", body.empty() ? "" : ",", kind.name);
    append_json(body, *limit);
  }
  if (!body.empty()) out += "\"limits\":{" + body + "},";
}

namespace {

// `,"hold":[…],"velocity":[…]` of what is there.
void append_motion(std::string& out, const std::vector<double>& hold,
                   const std::vector<std::optional<Vec3>>& velocity) {
  for (std::size_t i = 0; i < hold.size(); ++i) {
    out += i ? "," : ",\"hold\":[";
    append_json(out, hold[i]);
  }
  if (!hold.empty()) out += ']';
  for (std::size_t i = 0; i < velocity.size(); ++i) {
    out += i ? "," : ",\"velocity\":[";
    if (velocity[i]) {
      append_json(out, *velocity[i]);
    } else {
      out += "null";
    }
  }
  if (!velocity.empty()) out += ']';
}

// The list of the key, one entry a point; empty where there is none.
const nlohmann::json& list_of(const JsonFields& fields, const char* key, std::size_t points) {
  static const nlohmann::json kNone = nlohmann::json::array();
  if (!fields.has(key)) return kNone;
  const nlohmann::json& list = fields.value(key);
  if (!list.is_array() || list.size() != points) {
    fields.refuse(fmt::format("{} must be a list of {}, one a point, found {}", key, points,
                              list.is_array() ? fmt::format("{}", list.size()) : shown(list)));
  }
  return list;
}

std::vector<LegRange> parse_ranges(const JsonFields& fields, const char* key, std::size_t points) {
  std::vector<LegRange> ranges;
  if (!fields.has(key)) return ranges;
  const nlohmann::json& list = fields.value(key);
  const auto sound = [&](const nlohmann::json& range) {
    return range.is_array() && range.size() == 2 && range[0].is_number_unsigned() &&
           range[1].is_number_unsigned() &&
           range[0].get<std::size_t>() < range[1].get<std::size_t>() &&
           range[1].get<std::size_t>() < points;
  };
  if (!list.is_array() || !std::all_of(list.begin(), list.end(), sound)) {
    fields.refuse(fmt::format("{} must be a list of [a,b] with a < b, points of the path", key));
  }
  for (const auto& range : list) ranges.push_back({range[0], range[1]});
  return ranges;
}

void parse_holds(const JsonFields& fields, PathRecord& record) {
  for (const auto& value : list_of(fields, "hold", record.points.size())) {
    const std::string what = fmt::format("hold[{}]", record.hold.size());
    record.hold.push_back(fields.number(value, what));
    if (record.hold.back() < 0) {
      fields.refuse(fmt::format("{} must be >= 0 s, found {}", what, shown(value)));
    }
  }
}

void parse_velocities(const JsonFields& fields, PathRecord& record) {
  for (const auto& value : list_of(fields, "velocity", record.points.size())) {
    const std::size_t i = record.velocity.size();
    const std::string what = fmt::format("velocity[{}]", i);
    record.velocity.emplace_back();
    if (value.is_null()) continue;
    record.velocity[i] = fields.point(value, what);
    if (!record.hold.empty() && record.hold[i] > 0 && !record.velocity[i]->isZero(0)) {
      fields.refuse(fmt::format("{} must be zero or null where the path holds, found {}", what,
                                shown(value)));
    }
  }
}

}  // namespace

std::string to_json_line(const PathRecord& record) {
  std::string line = "{\"type\":\"path\",\"id\":";
  append_json(line, std::string_view(record.id));
  line += ",\"status\":";
  append_json(line, name(record.status));
  line += ',';
  append_json(line, record.provenance);
  if (!record.message.empty()) {
    line += "\"message\":";
    append_json(line, std::string_view(record.message));
    line += ',';
  }
  if (!record.search.empty()) line += "\"search\":" + record.search + ',';
  if (record.origin) {
    append_ranges(line, "kept", record.origin->kept);
    append_ranges(line, "mended", record.origin->mended);
  }
  if (!record.points.empty()) {
    line += "\"length\":";
    append_json(line, length(record.points));
    line += ',';
  }
  line += "\"points\":[";
  for (std::size_t i = 0; i < record.points.size(); ++i) {
    if (i) line += ',';
    append_json(line, record.points[i]);
  }
  line += ']';
  append_motion(line, record.hold, record.velocity);
  line += "}\n";
  return line;
}

PathRecord parse_path_record(std::string_view json, std::string_view source, std::size_t line) {
  const JsonFields fields(json, source, line);
  fields.require_type("path");
  PathRecord record;
  record.id = fields.text("id");
  record.status = fields.word("status", kPathStatusWords, PathStatus::found);
  record.provenance = fields.provenance();
  record.message = fields.text("message", "");
  if (fields.has("search")) record.search = fields.value("search").dump();
  if (fields.has("points")) record.points = fields.points("points");
  if (record.status == PathStatus::found && record.points.empty()) {
    fields.refuse("points must hold at least one point when the status is found, found none");
  }
  if (fields.has("kept") || fields.has("mended")) {
    record.origin = {parse_ranges(fields, "kept", record.points.size()),
                     parse_ranges(fields, "mended", record.points.size())};
  }
  parse_holds(fields, record);
  parse_velocities(fields, record);
  return record;
}

std::optional<std::string_view> mismatch(const Provenance& a, const Provenance& b) {
  if (a.map != b.map) return "map";
  if (a.frame != b.frame) return "frame";
  if (a.vehicle.has_value() != b.vehicle.has_value()) return "vehicle";
  if (a.vehicle && a.vehicle->half != b.vehicle->half) return "vehicle";
  if (a.margin != b.margin) return "margin";
  return std::nullopt;
}

void require_map_agrees(const Provenance& record, const Provenance& ours, std::string_view source,
                        std::size_t line) {
  if (record.map && ours.map && *record.map != *ours.map) {
    throw InputError(
        source, line,
        fmt::format("made for another map: expected {}, found {}", *ours.map, *record.map));
  }
  if (record.frame && ours.frame && *record.frame != *ours.frame) {
    throw InputError(source, line,
                     fmt::format("expected frame {}, as the map has, found {}", name(*ours.frame),
                                 name(*record.frame)));
  }
}

Provenance provenance_of(const CollisionScene& scene) {
  return {scene.map().hash(), scene.map().spec().frame.axes, scene.vehicle(), scene.margin()};
}

}  // namespace geom
