#pragma once

// A folder for an authority as records: how it was made, and what it claims of each flight.
//
// Example:
//   traj::Submission submission{.made_by = "skyway 0.1", .flights = 1};
//   submission.method.origin = {47.4, 8.5, 400};
//   const std::string text = traj::to_json_line(submission);
//   assert(traj::read_submission(text, "submission.json").method.origin.height == 400);
//
// docs/formats.md describes both.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geom/map/map_doubts.h"
#include "geom/record/record.h"
#include "traj/flight/energy.h"
#include "traj/mission/formats/flier.h"
#include "traj/proof/limits.h"
#include "traj/record/terrain_claim.h"
#include "traj/record/tube_record.h"
#include "traj/submit/risk_rules.h"
#include "traj/together/check_together.h"

namespace traj {

// A file that a claim rests on, by the name that it has outside of the folder.
struct SourceFile {
  std::string name;
  std::string sha256;
  std::string date = {};  // as the file says; may be empty

  friend bool operator==(const SourceFile&, const SourceFile&) = default;
};

// What was asked for, the same for all flights. Whoever checks the folder derives it all again.
struct SubmissionMethod {
  geom::Provenance made_for;    // the map; vehicle and margin where options gave them
  geom::GeodeticOrigin origin;  // of the map's (0, 0, 0)
  Limits limits;                // beside those of the records
  std::size_t volumes = 8;      // of airspace for each flight, at most
  double buffer = 0;            // m around the vehicle and its margin
  RiskRules risk;
  double floor = 0;                        // m in the map's z: no ground is lower
  std::string autopilot = "any";           // whose returns the off-nominal volumes hold
  std::optional<std::string> params;       // the operator's name of autopilot.params
  std::optional<double> return_height;     // m above home; else the autopilot's own
  std::optional<Uncertainty> navigation;   // how wrong it may be about its place
  std::optional<double> drag;              // 1/s; else the usual one
  double geoid = 0;                        // m: sea level above the ellipsoid, for missions
  std::optional<std::string> geoid_grid;   // the operator's name of geoid.gtx, in place of this
  std::optional<double> ground;            // m in the map's z: where missions take off
  std::optional<SourceFile> ground_model;  // below missions above terrain: terrain.ground
  std::optional<double> terrain_error;     // m that the autopilot's terrain may be off that ground
  std::optional<SurfaceBand> surface;      // above that ground, of aircraft that follow the surface
  std::optional<Energy> energy;            // of the vehicle's profile
  std::optional<double> endurance;         // s, as the operator says
  std::optional<std::string> begins;       // of missions, which have no times: the first instant
  std::optional<std::string> ends;         // and the last
  std::optional<TogetherRule> together;    // by which trajectories are compared; exact
  std::optional<SourceFile> tubes;  // whose proved tubes take the place of the margin in volumes
};

// How many pairs that come too near a folder names.
inline constexpr std::size_t kMostNamedPairs = 20;

// What came out where trajectories were compared with one another.
struct FlightPairs {
  std::size_t compared = 0;
  std::size_t refused = 0;                        // come too near
  std::vector<std::array<std::string, 2>> named;  // ids of the first of these

  friend bool operator==(const FlightPairs&, const FlightPairs&) = default;
};

// The files of zones of airspace that a map's history names, by name and hash.
std::vector<SourceFile> zones_of(const geom::BoxMapSpec& spec);

struct Submission {
  std::string made_by;  // "skyway 0.1.0"
  SubmissionMethod method;
  std::vector<std::string> missions;     // files in missions/, by name
  std::optional<SourceFile> population;  // of which population.csv is a part
  std::vector<SourceFile> zones;         // closed in the map: zones_of() its history
  geom::MapDoubts doubts;                // of the map, by its history
  std::size_t flights = 0;
  std::optional<FlightPairs> pairs;  // where the method asks for it
};

std::string to_json_line(const Submission& submission);  // ends with a newline
// Throws geom::InputError(source, …) for anything that to_json_line() does not write.
Submission read_submission(std::string_view json, std::string_view source);

// Of one flight. All of it follows from the files of the folder.
struct FlightClaims {
  std::string id;
  std::string kind;     // "trajectory" or "mission"
  std::string volumes;  // the files of its volumes and risk volumes, by their path in the folder
  std::string risk;
  std::string vehicle;       // its name
  Vec3 half = Vec3::Zero();  // m: of the box that holds it in every attitude
  double margin = 0;         // m around this
  std::string begins;        // instants
  std::string ends;
  double duration = 0;                       // s; of missions an estimate
  std::optional<double> clearance = {};      // m: the least distance to an obstacle
  std::optional<TubeClaim> tube = {};        // in place of the margin in its volumes
  std::optional<TerrainClaim> terrain = {};  // of a mission with heights above terrain
  double speed = 0;                          // m/s: the limit that the flight keeps
  double top = 0;                            // m above the floor: the highest of its geography
  ContingencySize contingency = {};
  double buffer = 0;                   // m: the widest of its ground risk buffers
  std::optional<double> returns = {};  // the share of the time from which its return is proved
  std::optional<double> energy = {};   // J that it takes at most
  std::optional<double> people = {};   // touched by its buffers at most, where a raster is given
  std::size_t people_unknown = 0;      // cells without a number among them
};

std::string to_json_line(const FlightClaims& claims);  // ends with a newline
// Throws geom::InputError(source, line, …) as above.
FlightClaims parse_flight_claims(std::string_view json, std::string_view source, std::size_t line);

}  // namespace traj
