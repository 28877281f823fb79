#include "geom/record/record.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <tuple>

#include "geom/base/error.h"
#include "geom/collision/collision.h"
#include "geom/text/json_fields.h"
#include "geom/text/json_line.h"
#include "geom/text/parse_json.h"

namespace geom {
namespace {

JsonLine object_of(const Vehicle& vehicle) {
  JsonLine line;
  line.add("name", vehicle.name).add("half", vehicle.half);
  add(line, vehicle.limits);
  return line;
}

void add_origin(JsonLine& line, const PathOrigin& origin) {
  const auto ends = [](const LegRange& range) { return std::tuple(range.first, range.last); };
  line.add("kept", origin.kept, ends).add("mended", origin.mended, ends);
}

// The list of the key, one entry a point; empty where there is none.
const nlohmann::json& list_of(const JsonFields& fields, const char* key, std::size_t points) {
  static const nlohmann::json kNone = nlohmann::json::array();
  if (!fields.has(key)) return kNone;
  const nlohmann::json& list = fields.value(key);
  if (!list.is_array() || list.size() != points) {
    fields.refuse({.key = std::string(key),
                   .expected = fmt::format("a list of {}, one a point", points),
                   .found = list.is_array() ? fmt::format("{}", list.size()) : shown(list)});
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
    fields.refuse(
        {.key = std::string(key), .expected = "a list of [a,b] with a < b, points of the path"});
  }
  for (const auto& range : list) ranges.push_back({range[0], range[1]});
  return ranges;
}

void parse_holds(const JsonFields& fields, PathRecord& record) {
  for (const auto& value : list_of(fields, "hold", record.points.size())) {
    const std::string what = fmt::format("hold[{}]", record.hold.size());
    record.hold.push_back(fields.number(value, what));
    if (record.hold.back() < 0) {
      fields.refuse({.key = what, .expected = ">= 0 s", .found = shown(value)});
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
      fields.refuse(
          {.key = what, .expected = "zero or null where the path holds", .found = shown(value)});
    }
  }
}

// With how much longer than it the path is.
void add_bound(JsonLine& line, const PathRecord& record) {
  line.add("bound", record.bound);
  if (record.bound && *record.bound > 0 && !record.points.empty()) {
    line.add("gap", length(record.points) / *record.bound - 1);
  }
}

void parse_bound(const JsonFields& fields, PathRecord& record) {
  record.bound = fields.number("bound");
  if (record.bound && *record.bound < 0) fields.refuse({.key = "bound", .expected = ">= 0"});
}

}  // namespace

void add(JsonLine& line, const Provenance& provenance) {
  line.add("map", provenance.map);
  if (provenance.frame) line.add("frame", name(*provenance.frame));
  if (provenance.vehicle) line.add("vehicle", object_of(*provenance.vehicle));
  line.add("margin", provenance.margin);
}

std::string to_json_line(const PathRecord& record) {
  JsonLine line;
  line.add("type", "path").add("id", record.id).add("status", name(record.status));
  add(line, record.provenance);
  add(line, record.time);
  if (record.closed_times) line.add("timed_boxes", "always_there");
  if (!record.message.empty()) line.add("message", record.message);
  if (!record.search.empty()) line.add_json("search", record.search);
  if (record.origin) add_origin(line, *record.origin);
  if (!record.points.empty()) line.add("length", length(record.points));
  add_bound(line, record);
  line.add("points", record.points);
  if (!record.hold.empty()) line.add("hold", record.hold);
  if (!record.velocity.empty()) line.add("velocity", record.velocity);
  return line.line();
}

PathRecord parse_path_record(std::string_view json, std::string_view source, std::size_t line) {
  return read_path_record(JsonFields(json, source, line));
}

PathRecord read_path_record(const JsonFields& fields) {
  fields.require_type("path");
  PathRecord record;
  record.id = fields.text("id");
  record.status = fields.word("status", kPathStatusWords, PathStatus::found);
  record.provenance = read_provenance(fields);
  record.time = read_flight_time(fields);
  record.closed_times = fields.text("timed_boxes", "") == "always_there";
  record.message = fields.text("message", "");
  if (fields.has("search")) record.search = fields.value("search").dump();
  if (fields.has("points")) record.points = fields.points("points");
  if (record.status == PathStatus::found && record.points.empty()) {
    fields.refuse(
        {.says = "points must hold at least one point when the status is found", .found = "none"});
  }
  if (fields.has("kept") || fields.has("mended")) {
    record.origin = {parse_ranges(fields, "kept", record.points.size()),
                     parse_ranges(fields, "mended", record.points.size())};
  }
  parse_bound(fields, record);
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
        {.says = fmt::format("made for another map: this map is {}, the record names {}", *ours.map,
                             *record.map),
         .advice = "give that map, or make the record anew for this one"});
  }
  if (record.frame && ours.frame && *record.frame != *ours.frame) {
    throw InputError(source, line,
                     {.expected = fmt::format("frame {}, as the map has", name(*ours.frame)),
                      .found = std::string(name(*record.frame))});
  }
}

Provenance provenance_of(const CollisionScene& scene) {
  return {scene.map().hash(), scene.map().spec().frame.axes, scene.vehicle(), scene.margin()};
}

Provenance read_provenance(const JsonFields& fields) {
  Provenance p;
  if (fields.has("map")) p.map = fields.text("map");
  if (fields.has("frame")) {
    p.frame = axes_from_name(fields.text("frame"));
    if (!p.frame)
      fields.refuse({.key = "frame",
                     .expected = "\"enu\" or \"neu\"",
                     .found = shown(fields.value("frame"))});
  }
  if (fields.has("vehicle")) {
    const nlohmann::json& v = fields.value("vehicle");
    if (!v.is_object() || !v.contains("half")) {
      fields.refuse({.key = "vehicle", .expected = "an object with \"half\"", .found = shown(v)});
    }
    Vehicle vehicle;
    if (v.contains("name") && v["name"].is_string()) vehicle.name = v["name"].get<std::string>();
    vehicle.half = fields.point(v["half"], "vehicle.half");
    if (vehicle.half.minCoeff() < 0) {
      fields.refuse({.key = "vehicle.half", .expected = ">= 0", .found = shown(v["half"])});
    }
    if (v.contains("limits")) vehicle.limits = read_limits(fields, v["limits"], "vehicle.limits");
    p.vehicle = vehicle;
  }
  if ((p.margin = fields.number("margin")) && *p.margin < 0) {
    fields.refuse({.key = "margin", .expected = ">= 0", .found = shown(fields.value("margin"))});
  }
  if (p.margin && *p.margin > kLargestCoordinate) {
    fields.refuse(
        {.key = "margin", .expected = "within 1e8 m", .found = shown(fields.value("margin"))});
  }
  return p;
}

}  // namespace geom
