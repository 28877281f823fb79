#pragma once

// --origin: a place on Earth.

#include <string_view>

#include "geom/map/frame.h"

namespace cli {

inline constexpr const char* kOriginForm = "LAT,LON[,HEIGHT]";

// Latitude and longitude in degrees, and metres above the ellipsoid where these are known (else 0).
// Throws UsageError; `or_word` is what else is expected there: "auto", or nothing.
geom::GeodeticOrigin origin_from(std::string_view text, std::string_view or_word = "");

}  // namespace cli
