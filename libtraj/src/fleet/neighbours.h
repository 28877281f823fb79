#pragma once

// Conflicts by flight.

#include <cstdint>
#include <vector>

#include "traj/fleet/fleet_conflicts.h"

namespace traj {

// `conflicts` must outlive it.
class Neighbours {
 public:
  Neighbours(std::size_t flights, const FleetConflicts& conflicts)
      : conflicts_(conflicts), ends_(flights, 0), entries_(2 * conflicts.pairs.size()) {
    for (const auto& [a, b] : conflicts.pairs) {
      ++ends_[a];
      ++ends_[b];
    }
    std::vector<std::size_t> next(flights, 0);
    for (std::size_t i = 0, sum = 0; i < flights; ++i) {
      next[i] = sum;
      sum += ends_[i];
      ends_[i] = sum;
    }
    for (std::size_t k = 0; k < conflicts.pairs.size(); ++k) {
      const auto [a, b] = conflicts.pairs[k];
      entries_[next[a]++] = {b, k};
      entries_[next[b]++] = {a, k};
    }
  }

  // Calls f(other, span) for what is forbidden between the flight and each other, as departures of
  // the flight less that of the other; until f says false of one.
  template <class F>
  void each(std::uint32_t flight, const F& f) const {
    for (std::size_t i = flight == 0 ? 0 : ends_[flight - 1]; i < ends_[flight]; ++i) {
      const auto [other, pair] = entries_[i];
      for (const DepartureSpan& span : conflicts_.of(pair)) {
        const bool second = other < flight;
        if (!f(other, second ? span : DepartureSpan{-span.high, -span.low})) break;
      }
    }
  }

 private:
  struct Entry {
    std::uint32_t other = 0;
    std::size_t pair = 0;
  };

  const FleetConflicts& conflicts_;
  std::vector<std::size_t> ends_;  // of each flight's in `entries_`
  std::vector<Entry> entries_;
};

}  // namespace traj
