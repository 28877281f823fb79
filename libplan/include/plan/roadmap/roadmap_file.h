#pragma once

// `.roadmap`: a roadmap as a ZIP of NumPy arrays (docs/formats.md).

#include <iosfwd>

#include "geom/archive/array_archive.h"
#include "plan/roadmap/roadmap.h"

namespace plan {

void write_roadmap(std::ostream& out, const Roadmap& roadmap);

bool is_roadmap(const geom::ArrayArchive& archive);

// Throws geom::InputError for another kind of file, arrays of other lengths, and an axis or a sign
// that is none. Edges are opened lazily: one to a bend that is not there is refused where a search
// meets it, and what an edge crosses is not looked at.
Roadmap read_roadmap(const geom::ArrayArchive& archive);

void verify_roadmap(const Roadmap& roadmap);  // every edge, and the lattice; InputError

}  // namespace plan
