#pragma once

// The items of LAZ points in the formats 0 to 5, one after the other in one code (Isenburg 2013).

#include <vector>

#include "laz_item_decoder.h"
#include "laz_setup.h"

namespace geom {

// Decoders for one chunk, in the order of `setup`. `first` holds the chunk's first point, which
// stands there as in LAS, `setup.point_bytes` long.
std::vector<std::unique_ptr<LazItemDecoder>> laz_item_decoders(
    const LazSetup& setup, std::span<const unsigned char> first);

// That first point.
LazPoint first_laz_point(const LazSetup& setup, std::span<const unsigned char> first);

}  // namespace geom
