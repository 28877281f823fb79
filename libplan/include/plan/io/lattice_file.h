#pragma once

// `.lattice`: a lattice as a ZIP of NumPy arrays in sparse 8x8x8 blocks (docs/formats.md).

#include <iosfwd>

#include "geom/io/array_archive.h"
#include "plan/lattice.h"

namespace plan {

void write_lattice(std::ostream& out, const Lattice& lattice);

// Checks every shape, size and bit: an edge to a blocked node, out of the lattice, or of another
// connectivity is refused with InputError.
Lattice read_lattice(const geom::ArrayArchive& archive);

bool is_lattice(const geom::ArrayArchive& archive);  // whether the archive says so

}  // namespace plan
