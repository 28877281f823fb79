#pragma once

// A planned way home, as it is shown.

#include <optional>
#include <string>
#include <string_view>

#include "geom/record/record.h"

namespace cli {

// From any instant between `from` and `until` the vehicle brakes, flies straight to the first of
// `points`, along them, and lands at the last.
struct Contingency {
  std::string id;                       // of the flight
  double from = 0;                      // s of the flight, closed
  double until = 0;                     // s, not before `from`
  std::string site = {};                // where it lands
  geom::Polyline points = {};           // m; empty: no way was found from these instants
  std::optional<double> length = {};    // m, at most
  std::optional<double> duration = {};  // s from the order to the ground, at most
  // The last instant up to which there is enough energy for the way; `until` where nothing is known
  // of energy, and before `from` where there is never enough.
  double latest = 0;
  bool bounds_energy = false;  // whether the record says that
  std::string message = {};    // why there is no way, in words; may be empty
  geom::Provenance provenance = {};

  bool found() const { return !points.empty(); }
};

// A record of skyway-plan --home. Throws geom::InputError(source, line, …) for anything else.
Contingency parse_contingency(std::string_view json, std::string_view source, std::size_t line);

}  // namespace cli
