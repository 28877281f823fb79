#include "geom/map/time_span.h"

#include <fmt/format.h>

#include <cmath>

#include "geom/text/instant.h"

namespace geom {

std::optional<std::string> span_fault(const TimeSpan& span) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto is_time = [](double t) { return std::abs(t) <= kLargestTime; };  // no NaN is
  if (!is_time(span.from) && span.from != -kInfinity) {
    return fmt::format("from must be seconds after the epoch within {:g}, or -infinity, found {}",
                       kLargestTime, span.from);
  }
  if (!is_time(span.until) && span.until != kInfinity) {
    return fmt::format("until must be seconds after the epoch within {:g}, or infinity, found {}",
                       kLargestTime, span.until);
  }
  if (span.from > span.until) {
    return fmt::format("from must be at most until, found {} and {}", span.from, span.until);
  }
  return std::nullopt;
}

}  // namespace geom
