#pragma once

// Options that are comma-separated numbers, as `--from x,y,z`.

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geom/record/place.h"
#include "geom/shape/aabb.h"

namespace cli {

// Exactly `count` finite numbers separated by commas, within geom::kLargestCoordinate.
std::optional<std::vector<double>> parse_numbers(std::string_view text, std::size_t count);

// A point "x,y,z", or a box "x0,y0,z0,x1,y1,z1" with min <= max; a usage error otherwise.
CLI::Option* add_point(CLI::App& app, const std::string& flag, std::optional<geom::Vec3>& point,
                       const std::string& description);
// A place in one of kPlaceForms.
CLI::Option* add_place(CLI::App& app, const std::string& flag, std::optional<geom::Place>& place,
                       const std::string& description);
CLI::Option* add_box(CLI::App& app, const std::string& flag, std::optional<geom::Aabb>& box,
                     const std::string& description);

}  // namespace cli
