#pragma once

// The boxes of a map that are not always there.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "geom/base/error.h"
#include "geom/map/time_span.h"

namespace geom {

struct TimedBoxes {
  std::span<const std::uint64_t> box;  // indices, ascending
  std::span<const TimeSpan> time;      // when each is there; as many

  TimeSpan of(std::size_t i) const {
    const auto at = std::lower_bound(box.begin(), box.end(), i);
    if (at == box.end() || *at != i) return {};
    return time[static_cast<std::size_t>(at - box.begin())];
  }
};

// Why they cannot be those of a map of so many boxes: another number of times than of
// boxes, indices that do not ascend or are beyond, a time that is none or always, no epoch.
// Nothing where they can.
std::optional<Fault> timed_fault(const TimedBoxes& timed, std::size_t boxes,
                                 const std::optional<std::string>& epoch);

}  // namespace geom
