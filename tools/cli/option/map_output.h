#pragma once

// What every tool that makes a map shares: the options of its bounds, and writing it.

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/option/common.h"
#include "geom/map/map_draft.h"

namespace cli {

// `seal_default` in words, for the help.
void add_map_options(CLI::App& app, geom::MakeMapOptions& map,
                     const std::string& seal_default = "0");

// --allow-skipped
void add_allow_skipped(CLI::App& app, bool& allowed);

// Facts about what was read, as --stats writes them.
nlohmann::ordered_json to_json(const std::vector<geom::Fact>& facts);

// Warns of boxes beyond the bounds of the map, which was made of `source`.
void warn_of_beyond(const geom::MadeMap& made, const std::string& source, const Common& common);

// Writes the map and, where --stats asks for it, its counts after those of `stats`; warns of boxes
// beyond the bounds.
void write_map(const Common& common, const std::string& output, const geom::MadeMap& made,
               const std::string& source, nlohmann::ordered_json stats);

// Makes the map of the draft, and writes it.
void write_map(const Common& common, const std::string& output, geom::MapDraft draft);

}  // namespace cli
