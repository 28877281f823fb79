#pragma once

// The proof of a folder for an authority that somebody else made (skyway-submit).

#include <CLI/CLI.hpp>
#include <string>

#include "cli/run.h"

namespace checking {

// Whether the argument names a folder; then no other argument or option of a check goes with it:
// throws cli::UsageError where one was given.
bool is_folder(const CLI::App& app, const std::string& path);

// Holds every file against the manifest, each flight against the map, and every claim against what
// follows from the files. Writes one line to `report`, and tells what is refused. Nothing in the
// folder is believed. Throws geom::InputError for files of another form.
cli::Exit check_folder(const cli::Common& common, const std::string& path,
                       const std::string& report);

}  // namespace checking
