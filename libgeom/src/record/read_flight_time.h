#pragma once

// When a flight begins, of any JSON object that says so.

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "geom/record/flight_time.h"

namespace geom {

// `refuse` is told what is wrong, and throws.
FlightTime flight_time_of(const nlohmann::json& object,
                          const std::function<void(const std::string&)>& refuse);

}  // namespace geom
