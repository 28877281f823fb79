#pragma once

// When a flight begins: seconds after an instant that all flights of a stream share.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "geom/base/error.h"
#include "geom/text/instant.h"

namespace geom {

inline constexpr int kLargestPriority = 1000000;
inline constexpr double kLeastTime = 1e-9;  // seconds: a smaller one that is not 0 is refused

// What records say of it; what they do not say is absent, and not written.
struct FlightTime {
  std::optional<std::string> epoch;  // the instant, as epoch_from() writes it
  std::optional<double> start;       // seconds after the epoch that it begins
  std::optional<double> earliest;    // seconds after the epoch between which it may begin
  std::optional<double> latest;
  std::optional<int> priority;  // higher departs first; within kLargestPriority

  // Where no start is said the earliest, and 0 where that is not said either.
  double starts() const { return start.value_or(earliest.value_or(0)); }
  bool any() const { return epoch || start || earliest || latest || priority; }

  friend bool operator==(const FlightTime&, const FlightTime&) = default;
};

// Whether it is a whole number within kLargestPriority.
bool is_priority(double value);

// Why these times cannot be: one that is no number within kLargestTime, or smaller than
// kLeastTime and not 0, a start that is not within earliest and latest. Nothing where they can.
std::optional<Fault> time_fault(const FlightTime& time);

class JsonFields;
class JsonLine;

// Adds the members epoch, start, earliest, latest and priority: those that are present.
void add(JsonLine& line, const FlightTime& time);

// Throws InputError where a value cannot be.
FlightTime read_flight_time(const JsonFields& fields);

// Throws InputError(source, line, …) where one of the two has an epoch that the other has not.
void require_epoch_agrees(const std::optional<std::string>& epoch,
                          const std::optional<std::string>& ours, std::string_view source,
                          std::size_t line);

}  // namespace geom
