#include "geom/record/start_on_map.h"

#include <fmt/format.h>

#include "geom/base/error.h"

namespace geom {

std::optional<double> start_on(const BoxMap& map, const FlightTime& time, std::string_view source,
                               std::size_t line) {
  const auto& epoch = map.spec().epoch;
  const bool counts = time.start && !map.timed().empty();
  if (epoch && (time.epoch ? *time.epoch != *epoch : counts)) {
    throw InputError(source, line,
                     {.expected = fmt::format("the epoch of the map, {}", *epoch),
                      .found = std::string(time.epoch.value_or("none")),
                      .advice = "seconds after different instants cannot be compared"});
  }
  return counts ? time.start : std::nullopt;
}

}  // namespace geom
