#pragma once

// What every tool that makes a map shares: the options of its bounds, and writing it.

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "cli/option/common.h"
#include "geom/map/make_map.h"

namespace cli {

struct MapOptions {
  geom::MakeMapOptions map;
  std::optional<double> seal;  // --seal

  // `seal_default` in words, for the help.
  void add_to(CLI::App& app, const std::string& seal_default = "0");
  geom::MakeMapOptions make(double seal_default = 0) const;
};

// What a map's history records of them.
nlohmann::ordered_json history_of(const geom::MakeMapOptions& options);

// Writes the map and, where --stats asks for it, its counts after those of `stats`; warns of boxes
// beyond the bounds.
void write_map(const Common& common, const std::string& output, const geom::MadeMap& made,
               const std::string& source, nlohmann::ordered_json stats);

}  // namespace cli
