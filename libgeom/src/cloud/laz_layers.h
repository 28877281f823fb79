#pragma once

// The chunks of LAZ in the formats 6 to 10: a layer for each thing that changes from point to
// point, so that those that a map does not need are skipped. Formats and constants are those of
// the published LASzip format, version 3 of its items; the models are Isenburg's (2013).

#include "laz_chunks.h"

namespace geom {

// Reads one chunk that begins with its first point. Returns its number of points, which the chunk
// itself says, and which must be 1 to `at_most`. Throws InputError where layers are cut short or
// longer than their points.
std::uint64_t read_laz_layers(ByteSource& bytes, const LazSetup& setup, std::uint64_t at_most,
                              const LazPointSink& sink);

}  // namespace geom
