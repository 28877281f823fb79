#pragma once

// The chunks of LAZ in the formats 6 to 10: a layer for each thing that changes from point to
// point, so that those that a map does not need are skipped. Formats and constants are those of
// the published LASzip format, version 3 of its items; the models are Isenburg's (2013).

#include <array>
#include <cstdint>
#include <vector>

#include "byte_source.h"
#include "laz_item_decoder.h"
#include "laz_setup.h"

namespace geom {

// What a map needs of one chunk, still compressed.
struct LazLayers {
  struct Layer {
    std::uint64_t at = 0;  // its place in the file
    std::vector<unsigned char> bytes;
  };
  std::vector<unsigned char> first;  // the first point, as in LAS
  std::uint64_t points = 0;          // as the chunk itself says
  std::array<Layer, 3> layers;       // places with returns and channels, heights, classes
};

// Reads a chunk that begins with its first point, to its end. Throws InputError where layers are
// cut short, or where it does not say that it has 1 to `at_most` points.
LazLayers read_laz_layers(ByteSource& bytes, const LazSetup& setup, std::uint64_t at_most);

// Its points. Throws InputError(source, …) where layers are longer or shorter than their points.
void decode_laz_layers(const LazLayers& chunk, const LazSetup& setup, std::string_view source,
                       const LazPointSink& sink);

}  // namespace geom
