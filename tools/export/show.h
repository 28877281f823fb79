#pragma once

// The files of all flights of a show, in a folder that appears whole or not at all.

#include <span>

#include "exporter.h"

namespace exporting {

// Makes the folder options.show: a file for each flight, and show.yaml, which says when each
// begins. Every flight is proved as for a file of its own and, of a checked export, every pair of
// what the files will be flown as is proved apart, started at those times. Where anything is
// refused stderr says all of it, there is no folder, and the answer is no. Throws
// geom::InputError for ids that would be one file and for epochs that differ, cli::UsageError where
// something of that name is there already.
cli::Exit export_show(const cli::Common& common, const Options& options, Exporter& exporter,
                      std::span<const Flight> flights);

}  // namespace exporting
