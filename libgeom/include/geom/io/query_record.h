#pragma once

// Planning queries: JSON Lines, or CSV with a header.

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "geom/vec3.h"

namespace geom {

struct PlanQuery {
  std::string id;
  Vec3 from;
  Vec3 to;
};

// `{"id":"q1","from":[x,y,z],"to":[x,y,z]}` a line (without id: "q" and the line number), or CSV
// with columns id,from_x,…,to_z in any order and others ignored; with a column `set` the id is
// SET-ID. Throws InputError(source, line, …) at the first malformed line, for an id that comes
// twice, and for a stream without queries.
std::vector<PlanQuery> read_plan_queries(std::istream& in, std::string_view source);

}  // namespace geom
