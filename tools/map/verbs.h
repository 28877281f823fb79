#pragma once

// The verbs of skyway-map. Each adds its subcommand and gives what runs it.

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "cli/run.h"
#include "geom/map/box_map.h"

namespace verbs {

struct Verb {
  CLI::App* app;
  std::function<cli::Exit()> run;
};

Verb info(CLI::App& app, const cli::Common& common);
Verb crop(CLI::App& app, const cli::Common& common);
Verb bounds(CLI::App& app, const cli::Common& common);
Verb join(CLI::App& app, const cli::Common& common);
Verb merge(CLI::App& app, const cli::Common& common);
Verb simplify(CLI::App& app, const cli::Common& common);
Verb inflate(CLI::App& app, const cli::Common& common);
Verb tile(CLI::App& app, const cli::Common& common);
Verb diff(CLI::App& app, const cli::Common& common);
Verb patch(CLI::App& app, const cli::Common& common);
Verb to_csv(CLI::App& app, const cli::Common& common);
Verb to_geojson(CLI::App& app, const cli::Common& common);
Verb to_ply(CLI::App& app, const cli::Common& common);
Verb to_gltf(CLI::App& app, const cli::Common& common);
Verb to_sdf(CLI::App& app, const cli::Common& common);

// What every verb has: a map and an output.
struct Files {
  std::string map;
  std::string output = "-";

  CLI::App* add(CLI::App& app, const char* name, const char* description);
};

// A map to make another thing of, which will stand for it: so all of it is verified.
geom::BoxMap open(const std::string& map, const cli::Common& common);

// Says of what has no times that boxes which the map has for a time are in it as always there.
void warn_of_times(const std::string& name, const geom::BoxMap& map, const cli::Common& common);

// Writes a map made of files.map, whose place it may take.
void write(const Files& files, const geom::BoxMap& made);

}  // namespace verbs
