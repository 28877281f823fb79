#pragma once

// What the user gave to look at, read and held together.

#include <optional>
#include <string>
#include <vector>

#include "geom/box_map.h"
#include "geom/io/record.h"
#include "plan/io/search_tree.h"
#include "plan/lattice.h"
#include "traj/io/corridor_record.h"
#include "traj/io/flight_log.h"
#include "traj/io/report_record.h"
#include "traj/io/trajectory_record.h"

namespace view {

// A record and where it stood.
template <class Record>
struct Read {
  Record record;
  std::string source;
  std::size_t line = 0;
};

struct Contents {
  std::optional<Read<geom::BoxMap>> map;
  std::vector<Read<plan::Lattice>> lattices;
  std::vector<Read<plan::SearchTreeRecord>> trees;
  std::vector<Read<geom::PathRecord>> paths;
  std::vector<Read<traj::TrajectoryRecord>> trajectories;
  std::vector<Read<traj::FlightLog>> flights;
  std::vector<Read<traj::CorridorShape>> corridors;
  std::vector<Read<traj::ReportSummary>> reports;
};

// Reads each file for what it is: archives by their meta.json, JSON Lines by "type", anything else
// as a flight log. Throws geom::InputError for what is none of these, for a second map, and where
// two of them were made for different maps or, beside a map, in another frame.
Contents read_contents(const std::vector<std::string>& files);

// The axes that a record is in: its own word, else the map's, else ENU.
geom::Axes axes_of(const Contents& contents, const geom::Provenance& provenance);

}  // namespace view
