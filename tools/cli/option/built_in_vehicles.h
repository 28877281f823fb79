#pragma once

// The profiles of data/vehicles that --vehicle knows by name.

#include <string_view>

namespace cli {

// The JSON text of data/vehicles/NAME.json, or nothing for another name.
std::string_view built_in_vehicle(std::string_view name);

}  // namespace cli
