#pragma once

// When a flight begins: seconds after an instant that all flights of a stream share.
//
// Example:
//   const geom::FlightTime time{.epoch = "2026-05-04T06:30:00Z", .earliest = 60, .latest = 300};
//   assert(time.starts() == 60 && !geom::time_fault(time));

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "geom/base/error.h"
#include "geom/text/instant.h"

namespace geom {

inline constexpr int kLargestPriority = 1000000;
inline constexpr double kLeastTime = 1e-9;  // seconds: a smaller one that is not 0 is refused

// The times of a flight as records say them. What a record does not say is absent, and not written.
struct FlightTime {
  std::optional<std::string> epoch;  // the instant, as epoch_from() writes it
  std::optional<double> start;       // seconds after the epoch that it begins
  std::optional<double> earliest;    // seconds after the epoch between which it may begin
  std::optional<double> latest;
  std::optional<int> priority;  // higher departs first; within kLargestPriority

  // The start; if it is absent the earliest, and 0 if that is absent, too.
  double starts() const { return start.value_or(earliest.value_or(0)); }
  bool any() const { return epoch || start || earliest || latest || priority; }

  friend bool operator==(const FlightTime&, const FlightTime&) = default;
};

// Whether it is a whole number within kLargestPriority.
bool is_priority(double value);

// What is wrong with the times: one that is no number within kLargestTime, or smaller than
// kLeastTime and not 0, or a start that is not within earliest and latest. Nothing if they are
// valid.
std::optional<Fault> time_fault(const FlightTime& time);

class JsonFields;
class JsonLine;

// Adds the members epoch, start, earliest, latest and priority: those that are present.
void add(JsonLine& line, const FlightTime& time);

// Throws InputError for a value that is not valid.
FlightTime read_flight_time(const JsonFields& fields);

// Throws InputError(source, line, …) if the two have different epochs, or only one has one.
void require_epoch_agrees(const std::optional<std::string>& epoch,
                          const std::optional<std::string>& ours, std::string_view source,
                          std::size_t line);

}  // namespace geom
