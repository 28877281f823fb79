#pragma once

// Seconds between instants of RFC 3339, and instants some seconds after another.

#include <optional>
#include <string>
#include <string_view>

namespace geom {

// Two doubles that the real difference lies between, next neighbours but for a few units in the
// last place; the same one twice where the difference is a double, as of whole seconds.
struct SecondsBetween {
  double least = 0;
  double most = 0;
};

// From `epoch` to `instant`, both as epoch_from() (flight_time.h) writes them. A day has 86,400 s,
// as in the calendar that they are written in: leap seconds do not count.
SecondsBetween seconds_between(std::string_view epoch, std::string_view instant);

// An instant in whole milliseconds that is not after, or not before, `seconds` after the epoch: the
// nearest, but for 1e-17 s. |seconds| at most 1e10. As epoch_from() writes it. Nothing outside of
// the years 0 to 9999.
std::optional<std::string> instant_not_after(std::string_view epoch, double seconds);
std::optional<std::string> instant_not_before(std::string_view epoch, double seconds);

// Whether an instant is not after, or not before, `seconds` after the epoch. In doubt false; what
// instant_not_after() and instant_not_before() give for the same two is never in doubt.
bool is_not_after(std::string_view instant, std::string_view epoch, double seconds);
bool is_not_before(std::string_view instant, std::string_view epoch, double seconds);

}  // namespace geom
