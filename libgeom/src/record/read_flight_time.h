#pragma once

// When a flight begins, of any JSON object that says so.

#include <functional>
#include <nlohmann/json_fwd.hpp>

#include "geom/base/error.h"
#include "geom/record/flight_time.h"

namespace geom {

// Is told what is wrong, and throws.
using Refusal = std::function<void(Fault)>;

FlightTime flight_time_of(const nlohmann::json& object, const Refusal& refuse);

}  // namespace geom
