#pragma once

// Obstacles that could not be built: refused, or allowed by name and remembered in the map.

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/option/common.h"
#include "geom/base/skipped.h"
#include "geom/map/box_map.h"

namespace cli {

class SkippedOption {
 public:
  void add_to(CLI::App& app);  // --allow-skipped

  // Throws geom::InputError(source, …) where something was skipped and that is not allowed; warns
  // of it where it is, and notes the count in `step` of the map's history.
  void settle(const geom::Skipped& skipped, const std::string& source, const Common& common,
              nlohmann::ordered_json& step) const;

 private:
  bool allowed_ = false;
};

// How many obstacles the steps of a map's history left out.
std::size_t skipped_in(const geom::BoxMapSpec& spec);

}  // namespace cli
