#pragma once

// Frame after frame: taken, encoded and written.

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "geom/base/execution.h"
#include "geom/picture/film.h"
#include "options.h"

namespace render {

using Times = std::vector<std::optional<double>>;  // seconds; nothing: no vehicle is shown

// Writes what the options name, and gives counts and times: of casting and shading (wall, and CPU
// of all threads), and of encoding and writing.
nlohmann::ordered_json shoot(const geom::picture::Film& film, const Times& times,
                             const Options& options, const geom::Execution& run);

}  // namespace render
