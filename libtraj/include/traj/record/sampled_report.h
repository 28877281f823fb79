#pragma once

// Reports of flight logs beside a map, as JSON Lines records of type "report".
//
// Example:
//   traj::SampledReport report{.id = "q1", .samples = 2};
//   report.result = traj::check_sampled(scene, {{{1, 1, 1}, {1, 2, 1}}}, {{0, 0.5}});
//   report.provenance = geom::provenance_of(scene);
//   std::cout << to_json_line(report, map);

#include <optional>
#include <string>

#include "geom/map/box_map.h"
#include "geom/record/record.h"
#include "traj/flight/flown_tube.h"
#include "traj/proof/sampled_flight.h"
#include "traj/record/tube_record.h"

namespace traj {

// Which flight logs are accepted, although no log can be a proof. By default none is. A log that
// touches something is never accepted.
struct SampledRule {
  bool sampled = false;             // that nothing was touched, at samples and straight between
  std::optional<double> clearance;  // m: that so much was kept there
  bool any_map = false;             // also where the log does not say of which map its places are
};

struct SampledReport {
  std::string id;
  SampledFlight result;
  std::size_t samples = 0;
  bool cut = false;  // the log does not hold the whole flight
  std::optional<FlownTube> plan;
  std::optional<TubeKind> tube;  // where the plan came with one
  geom::Provenance provenance;
  SampledRule rule = {};
  // The log lasts a shorter time than its plan, so that it cannot hold the whole flight.
  bool short_of_plan = false;
  bool map_said = true;           // by the log: its places are of this map
  std::string checked_hash = {};  // checked_hash() of the log; may be empty
};

// Why a log on `map` is refused; empty where its rule accepts it. A touch is always refused:
// "collision", "bounds"; so is a "gap" of more than kLongestGap. Without a rule the rest is
// "sampled". With one, "no_map" is a log that does not say its map, if the rule wants it to; "cut"
// one that broke off or is shorter than its plan; "clearance" one that came nearer than asked,
// "clearance_not_measured" one that was never in the air.
std::string_view reason_of(const SampledReport& report, const geom::BoxMap& map);

// Ends with a newline. "ok" only where the rule accepts it; "verdict" then says what was looked at:
// "sampled" or "clearance". `map` gives the source id of the obstacle that was hit.
std::string to_json_line(const SampledReport& report, const geom::BoxMap& map);

}  // namespace traj
