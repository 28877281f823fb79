#pragma once

// Planning queries: JSON Lines, CSV with a header, or GeoJSON.
//
// Example:
//   std::istringstream in(R"({"id":"q1","from":[1,1,1],"to":[9,1,1]})" "\n");
//   const std::vector<geom::PlanQuery> queries = geom::read_plan_queries(in, "queries.jsonl");
//   assert(queries[0].id == "q1" && queries[0].to.x() == 9);

#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geom/base/vec3.h"
#include "geom/record/flight_time.h"
#include "geom/record/locator.h"
#include "geom/record/record.h"

namespace geom {

struct PlanQuery {
  std::string id;
  Vec3 from;
  Vec3 to;
  std::optional<double> best_known;  // metres: the length of the best path known
  std::size_t line = 0;              // of the source; 0: none
  bool from_on_earth = false;        // given as degrees, not in the map's metres
  bool to_on_earth = false;
  FlightTime time = {};
  Provenance asked_of = {};  // the map, frame, vehicle and margin that it says, if any
};

// The ends of a query that were given in metres, not in degrees.
std::vector<Vec3> ends_in_metres(const PlanQuery& query);

// `{"id":"q1","from":[x,y,z],"to":[x,y,z]}` a line (without id: "q" and the line number), or CSV
// with columns id,from_x,…,to_z in any order and others ignored; with a column `set` the id is
// SET-ID. The key "best_known", or the column best_known_m (a field may be empty), must be > 0. The
// keys "epoch", "start", "earliest" and "latest", or the columns epoch, start_s, earliest_s and
// latest_s (a field may be empty), say when it begins (flight_time.h). The keys "map", "frame",
// "vehicle" and "margin" of JSON Lines, the column margin, and
// the axes that a comment before the queries names ("# frame: neu"), are kept in `asked_of`:
// whoever answers compares them (require_asked_of()). Throws InputError(source, line, …) at the
// first malformed line, for an id that comes twice, for a column of these that comes twice, and for
// a stream without queries.
//
// Places may be on Earth: a text that parse_place() takes in place of [x,y,z]; columns
// from_latitude, from_longitude, from_height, to_latitude, … in place of from_x, …; or GeoJSON, of
// which each LineString is a query from its first to its last position, and so are two Points of
// one id. They need the locator of a map: without one they are refused.
std::vector<PlanQuery> read_plan_queries(std::istream& in, std::string_view source,
                                         const Locator* locator = nullptr);

}  // namespace geom
