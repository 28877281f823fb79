#pragma once

// What a report says of the returns of a flight, read back to be shown.
//
// Example:
//   const std::string json = R"({"action":"rtl","autopilot":"px4:1.17","height":60,"share":1,)"
//                            R"("duration":120,"longest":90,"gaps":[]})";
//   const auto returns = traj::parse_return_summary(json, "report.jsonl", 1);
//   assert(returns.gaps.empty() && returns.share == 1);

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geom/base/vec3.h"
#include "traj/record/return_report.h"

namespace traj {

// As ReturnGap: a time of the flight, s, from which no return is proved.
struct ReturnGapSummary {
  double from = 0;
  double until = 0;
  std::optional<std::uint64_t> item = {};  // of a mission, as its file counts
  std::string part = {};                   // of a mission: the manoeuvre; may be empty
  std::string autopilot = {};
  std::string phase = {};                // "braking", "climb", "way", "descent" or "landing"
  std::string reason = {};               // "collision", "bounds", "fence", "landing", "return", …
  std::optional<geom::Vec3> place = {};  // m: of what it would meet
  std::optional<std::uint64_t> box = {};    // its id in the source
  std::optional<std::uint64_t> fence = {};  // of the mission
};

// As ReturnReport.
struct ReturnSummary {
  std::string action;  // "rtl", "land" or "hold"
  std::string autopilot;
  std::optional<geom::Vec3> home = {};      // the ground there, m
  double height = 0;                        // m above home
  double share = 0;                         // of the time from which a return is proved, 0 to 1
  double duration = 0;                      // s, of the flight
  double longest = 0;                       // s that a return may take
  std::vector<ReturnGapSummary> gaps = {};  // ascending, apart
  std::vector<TimedPlace> timeline = {};    // of a mission or a path
  std::optional<double> least_height = {};  // m above home with which there is no gap

  // If there is none: the least height at which returns are proved for as long as at any, and that
  // share.
  std::optional<double> best_height = {};
  std::optional<double> best_share = {};

  bool ok() const { return gaps.empty(); }
  // Whether returns at the best height are proved for longer than these.
  bool gains_by_height() const { return best_height && best_share && *best_share > share; }
};

// The member "return" of a report. Throws InputError(source, line, …) for anything else: a missing
// key, gaps that do not ascend or overlap or are beyond the flight, and a share that is larger than
// the gaps leave it.
ReturnSummary parse_return_summary(std::string_view json, std::string_view source,
                                   std::size_t line);

}  // namespace traj
