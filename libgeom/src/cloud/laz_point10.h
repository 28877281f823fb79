#pragma once

// POINT10 of LAZ: places and what else a point of the formats 0 to 5 has always (Isenburg 2013,
// "Compressing POINT10"). Of intensity, scan angle and source only the code is read.

#include "laz_item_decoder.h"

namespace geom {

// `raw` holds the 20 bytes of the chunk's first point, `first` its place. Version 1 or 2.
std::unique_ptr<LazItemDecoder> point10_decoder(unsigned version, const LazPoint& first,
                                                std::span<const unsigned char> raw);

}  // namespace geom
