#include "geom/map/time_span.h"

#include <fmt/format.h>

#include <cmath>

#include "geom/text/instant.h"

namespace geom {

std::optional<Fault> span_fault(const TimeSpan& span) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto is_time = [](double t) { return std::abs(t) <= kLargestTime; };  // no NaN is
  if (!is_time(span.from) && span.from != -kInfinity) {
    return Fault{
        .key = "from",
        .expected = fmt::format("seconds after the epoch within {:g}, or -infinity", kLargestTime),
        .found = fmt::to_string(span.from)};
  }
  if (!is_time(span.until) && span.until != kInfinity) {
    return Fault{
        .key = "until",
        .expected = fmt::format("seconds after the epoch within {:g}, or infinity", kLargestTime),
        .found = fmt::to_string(span.until)};
  }
  if (span.from > span.until) {
    return Fault{.key = "from",
                 .expected = "at most until",
                 .found = fmt::format("{} and {}", span.from, span.until)};
  }
  return std::nullopt;
}

}  // namespace geom
