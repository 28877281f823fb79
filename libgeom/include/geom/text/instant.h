#pragma once

// Instants of RFC 3339: read, the seconds between two, and those some seconds after another.
//
// Example:
//   assert(*geom::epoch_from("2026-05-04T06:30:00.500Z") == "2026-05-04T06:30:00.5Z");
//   assert(geom::seconds_between("2026-05-04T06:30:00Z", "2026-05-04T07:00:00Z").least == 1800);
//   assert(*geom::instant_not_after("2026-05-04T06:30:00Z", 90) == "2026-05-04T06:31:30Z");

#include <optional>
#include <string>
#include <string_view>

namespace geom {

inline constexpr double kLargestTime = 1e9;  // seconds, before or after an epoch

// An instant of RFC 3339 in UTC, in the one form in which it is always written:
// "2026-05-04T06:30:00Z", with a fraction of a second only if it is not 0. Nothing for other text:
// another offset than Z or +00:00, a day that the month does not have, a leap second.
std::optional<std::string> epoch_from(std::string_view text);

// Two doubles, between which the real difference lies. They are a few units in the last place
// apart. They are equal if the difference is a double, as it is for whole seconds.
struct SecondsBetween {
  double least = 0;
  double most = 0;
};

// From `epoch` to `instant`, both as epoch_from() writes them. A day has 86,400 s,
// as in the calendar that they are written in: leap seconds do not count.
SecondsBetween seconds_between(std::string_view epoch, std::string_view instant);

// The nearest instant in whole milliseconds that is not after, or not before, `seconds` after the
// epoch, but for 1e-17 s; as epoch_from() writes it. |seconds| is at most 1e10. Nothing outside of
// the years 0 to 9999.
std::optional<std::string> instant_not_after(std::string_view epoch, double seconds);
std::optional<std::string> instant_not_before(std::string_view epoch, double seconds);

// Whether an instant is not after, or not before, `seconds` after the epoch. In doubt the answer is
// false. It is never in doubt for what instant_not_after() and instant_not_before() give.
bool is_not_after(std::string_view instant, std::string_view epoch, double seconds);
bool is_not_before(std::string_view instant, std::string_view epoch, double seconds);

}  // namespace geom
