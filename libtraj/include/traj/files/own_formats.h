#pragma once

// What Skyway's tools write for one another, as a table of formats.
//
// Example:
//   const std::string line = R"({"type":"path","id":"q1"})";
//   assert(geom::recognise(line, traj::files::own_formats()) == &traj::files::kPaths);

#include "geom/base/format.h"

namespace traj::files {

// Shards before what they are a part of, and roadmaps before the lattices that they were made with.
geom::Formats own_formats();

extern const geom::Format kShard;
extern const geom::Format kBoxMap;
extern const geom::Format kRoadmap;
extern const geom::Format kLattice;
extern const geom::Format kGround;

// Streams of records (JSON Lines).
extern const geom::Format kPaths;
extern const geom::Format kTrajectories;
extern const geom::Format kMoving;
extern const geom::Format kTrees;
extern const geom::Format kCorridors;
extern const geom::Format kCertificates;
extern const geom::Format kReports;
extern const geom::Format kContingencies;
extern const geom::Format kFlights;
extern const geom::Format kAnswers;
extern const geom::Format kQueries;

extern const geom::Format kQueryTable;  // CSV
extern const geom::Format kFlightLog;
extern const geom::Format kBenchmark;
extern const geom::Format kVehicleProfile;

}  // namespace traj::files
