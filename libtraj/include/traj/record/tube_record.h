#pragma once

// The tube of a flight, read back from the report of skyway-fly, and what it says of itself.
//
// Example:
//   const auto tube = traj::parse_tube(  // of skyway-fly --runs
//       R"({"type":"flight","id":"q1","controller":"cascade","monte_carlo":{"lost":0,"tube":)"
//       R"({"period":0.1,"largest":0.3,"tilt":0.2,"trajectory":"abc","radius":[0.2,0.3]}}})",
//       "flights.jsonl", 1);
//   assert(tube->claim.kind == traj::TubeKind::statistics && tube->claim.largest == 0.3);

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geom/record/record.h"
#include "geom/text/words.h"
#include "traj/tube/prove_tube.h"

namespace geom {
class JsonFields;
class JsonLine;
}  // namespace geom

namespace traj {

// What stands behind a tube: a proof for stated disturbances (docs/tube.md), or many simulated
// flights.
enum class TubeKind { proved, statistics };
inline constexpr geom::Words<TubeKind, 2> kTubeKindWords{{
    {TubeKind::proved, "proved"},
    {TubeKind::statistics, "statistics"},
}};

// What a report says of its tube. Nobody who reads it proves it again.
struct TubeClaim {
  TubeKind kind = TubeKind::statistics;
  double largest = 0;                             // m
  double tilt = 0;                                // rad: the vehicle tilts no further
  ControlLaw law = ControlLaw::geometric;         // that flies it
  std::optional<Disturbances> disturbances = {};  // for which it was proved
  std::string model = {};  // model_hash() of what flies; empty: its report does not say it
};

struct TubeRecord {
  std::string id = {};  // of the flight
  TubeClaim claim = {};
  std::vector<double> radius = {};   // m, in each period; empty: the proof was refused
  double period = 0;                 // s, > 0
  std::string trajectory = {};       // trajectory_hash(); empty: the proof was refused
  std::string refused = {};          // why there is no proof: a word of kTubeTroubleWords
  geom::Provenance provenance = {};  // of the flight
};

// Of a report that has a proved tube and one of runs, the proved one; nothing for a flight without
// any. Throws InputError(source, line, …) for what is no report of a flight, and for a tube with a
// radius that cannot be, another largest one, or no tilt, controller or hash of its trajectory; for
// a proved one with a member that is not known here, and for one of runs of which some were lost.
std::optional<TubeRecord> parse_tube(std::string_view json, std::string_view source,
                                     std::size_t line);

// Adds kind, largest, tilt, the controller and the disturbances.
void add(geom::JsonLine& line, const TubeClaim& claim);

// Reads these back. Throws InputError for a member that is missing, cannot be or is not known.
TubeClaim read_tube_claim(const geom::JsonFields& fields);

// "a tube of at most 0.031 m, proved for the simulated vehicle (model 1f2e3d4c) under the geometric
// controller in …", with the first digits of the model's hash,
// or "a tube of at most 0.05 m,
// from statistics and not proved".
std::string in_words(const TubeClaim& claim);

}  // namespace traj
