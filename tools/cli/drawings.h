#pragma once

// Anything that can be drawn on a map: paths, trajectories, search trees, corridors and flights,
// from JSON Lines and flight logs.

#include <string>
#include <vector>

#include "geom/box_map.h"
#include "geom/io/record.h"
#include "plan/io/search_tree.h"
#include "traj/io/corridor_record.h"
#include "traj/io/flight_log.h"
#include "traj/io/trajectory_record.h"

namespace cli {

struct Drawings {
  std::vector<geom::PathRecord> paths;               // found ones
  std::vector<traj::TrajectoryRecord> trajectories;  // solved ones
  std::vector<plan::SearchTreeRecord> trees;
  std::vector<traj::FlightLog> flights;
  std::vector<traj::CorridorShape> corridors;
  std::size_t failed = 0;  // records of paths and trajectories that there are not
};

enum class Corridors { refused, taken };  // not every picture shows regions

// Adds what the input holds. A first line that starts with "{" means records, whose kind each names
// ("type"; those of other kinds, as reports, are refused); else it is a flight log. Throws
// InputError for anything else, and for a record of another map or frame than `map`, where given.
void read_drawings(const std::string& input, const geom::BoxMap* map, Drawings& drawings,
                   Corridors corridors = Corridors::refused);

}  // namespace cli
