#pragma once

// Path records (JSON Lines), and what every record says of its origin.
//
// Example:
//   geom::PathRecord record{.id = "q1", .status = geom::PathStatus::found, .points = path};
//   record.provenance = geom::provenance_of(scene);  // map, frame, vehicle and margin
//   const std::string line = geom::to_json_line(record);
//   assert(geom::parse_path_record(line, "paths.jsonl", 1).points == path);

#include <cstddef>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geom/map/frame.h"
#include "geom/record/flight_time.h"
#include "geom/record/path_status.h"
#include "geom/shape/polyline.h"
#include "geom/vehicle/vehicle.h"

namespace geom {

// What a record was made for; members are absent if the record does not have them.
struct Provenance {
  std::optional<std::string> map;  // BoxMap::hash()
  std::optional<Axes> frame;
  std::optional<Vehicle> vehicle;
  std::optional<double> margin;  // metres
};

// The first in which they differ: "map", "frame", "vehicle" (its half sizes, not its
// limits) or "margin". Nothing where all are the same.
std::optional<std::string_view> mismatch(const Provenance& a, const Provenance& b);

// Throws InputError(source, line, …) if both name a map and it is not the same, or a frame. A
// member that one of them lacks counts as equal.
void require_map_agrees(const Provenance& record, const Provenance& ours, std::string_view source,
                        std::size_t line);

class CollisionScene;
Provenance provenance_of(const CollisionScene& scene);  // of things made with it

// Legs of a path from points[first] to points[last], first < last.
struct LegRange {
  std::size_t first = 0;
  std::size_t last = 0;

  friend bool operator==(const LegRange&, const LegRange&) = default;
};

// Where the legs of a replanned path come from. Together the ranges are the whole path, each once.
struct PathOrigin {
  std::vector<LegRange> kept;    // of the old path, bit for bit
  std::vector<LegRange> mended;  // new
};

struct PathRecord {
  std::string id;
  PathStatus status = PathStatus::unreachable;
  Polyline points;  // empty unless found
  Provenance provenance;
  std::string message;               // why there is no path, in words; may be empty
  std::string search;                // the planner's own report: a JSON object, or empty
  std::optional<PathOrigin> origin;  // of a replanned path
  std::optional<double> bound;       // metres: no path between its ends is shorter
  std::vector<double> hold;          // seconds to stand still at each point, >= 0; empty: nowhere
  std::vector<std::optional<Vec3>> velocity;  // m/s at each point where given; empty: nowhere
  FlightTime time;
  // Some boxes of the map are there for a time only, and counted as always there. So status and
  // bound are those of a world with at least as many obstacles as there are at any time.
  bool closed_times = false;
};

class JsonFields;
class JsonLine;

// Adds the members map, frame, vehicle and margin: those that are present.
void add(JsonLine& line, const Provenance& provenance);

// What a record says of its origin. Throws InputError where a value cannot be.
Provenance read_provenance(const JsonFields& fields);

std::string to_json_line(const PathRecord& record);  // ends with a newline

// Throws InputError(source, line, …) for anything that is not a path record: malformed JSON, a
// missing key, a number that is not finite, holds or velocities that are not one a point, a
// velocity other than zero where the path holds.
PathRecord parse_path_record(std::string_view json, std::string_view source, std::size_t line);
PathRecord read_path_record(const JsonFields& fields);

}  // namespace geom
