#pragma once

// What the user gave to look at: paths, trajectories, search trees, corridors, reports, ways home
// and flights, maps and lattices, whichever of these a file or a stream holds.

#include <optional>
#include <string>
#include <vector>

#include "cli/content/drone_file.h"
#include "cli/option/common.h"
#include "cli/option/degrees.h"
#include "cli/option/scenes.h"
#include "geom/map/box_map.h"
#include "geom/record/record.h"
#include "plan/lattice/lattice.h"
#include "plan/sampling/search_tree_file.h"
#include "traj/flight/flight_log.h"
#include "traj/home/contingency_record.h"
#include "traj/record/corridor_record.h"
#include "traj/record/pair_summary.h"
#include "traj/record/report_record.h"
#include "traj/record/trajectory_record.h"
#include "traj/record/tube_record.h"

namespace cli {

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
  std::vector<Read<traj::PairSummary>> pairs;         // beside the reports: flights held against
  std::vector<Read<traj::TogetherSummary>> together;  // one another
  std::vector<Read<traj::ContingencyRecord>> contingencies;
  std::vector<Read<traj::TubeRecord>> tubes;    // of the reports of simulated flights
  std::vector<traj::FileFlight> drone_flights;  // of drone files, whose paths stand above
};

// What is taken beside paths, trajectories, trees and flights: not every picture shows all.
struct ContentKinds {
  bool archives = false;  // of a map or a lattice
  bool corridors = false;
  bool reports = false;
  bool contingencies = false;
  // How drone files are read, as paths and the regions beside them; absent: they are refused.
  DroneFileOptions* drone_files = nullptr;
  // What is expected where a record has another type.
  std::string expected = "a record of type path, trajectory or tree";
};

// Reads each input for what it is: archives by their meta.json, JSON Lines by "type" (a query where
// there is none), drone files by how they begin (once the map is known, which gives the origin and
// the axes), anything else as a flight log. Throws geom::InputError for what is not taken, and for
// a second map.
Contents read_contents(const std::vector<std::string>& inputs, const ContentKinds& kinds = {});

// Throws geom::InputError where something was made for another map than `map` or, without one, than
// the first that names its map; and where it is in another frame than `map`. Paths, trajectories
// and flight logs may be of `map` before boxes that are there for a time were added (named_map.h);
// what says that something is free or clear, as reports do, may not. Nor may a report be of another
// trajectory than those of its id. `metres` refuses paths,
// trajectories and flight logs whose coordinates look like degrees on `map`.
void require_same_map(const Contents& contents, const geom::BoxMap* map,
                      const MetresOption& metres = MetresOption());

// Warns of flight logs that are drawn over the map and do not say that they are of it.
void warn_of_unsaid_maps(const Common& common, const Contents& contents);

// Leaves out paths that were not found and trajectories that were not solved; returns how many.
std::size_t drop_failed(Contents& contents);

}  // namespace cli
