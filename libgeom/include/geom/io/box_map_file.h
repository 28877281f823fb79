#pragma once

// `.boxmap`: a box map as a ZIP of NumPy arrays (docs/formats.md).

#include <iosfwd>

#include "geom/box_map.h"
#include "geom/io/array_archive.h"

namespace geom {

void write_box_map(std::ostream& out, const BoxMap& map);

// Views the archive's arrays, without copying the boxes. Checks the directory, shapes, types, tile
// ranges, and each tile's boxes (finite, min <= max, inside the tile's recorded extent); throws
// InputError otherwise.
BoxMap read_box_map(const ArrayArchive& archive);

// Whether the archive says that it is a box map.
bool is_box_map(const ArrayArchive& archive);

}  // namespace geom
