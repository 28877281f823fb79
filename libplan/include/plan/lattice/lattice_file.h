#pragma once

// Lattice files (`.lattice`): ZIPs of NumPy arrays in sparse 8x8x8 blocks (docs/formats.md).
//
// Example:
//   std::ostringstream out;
//   plan::write_lattice(out, plan::build_lattice(scene, {.spacing = 1}));
//   const std::string bytes = out.str();
//   const plan::Lattice lattice = plan::read_lattice(
//       geom::ArrayArchive::from_bytes(std::as_bytes(std::span(bytes)), "city.lattice"));

#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geom/archive/array_archive.h"
#include "plan/lattice/lattice.h"
#include "plan/lattice/lattice_part.h"

namespace geom {
class JsonFields;
}

namespace plan {

// Writes a lattice that was built or read, not a lazy one (lazy_lattice).
void write_lattice(std::ostream& out, const Lattice& lattice);

// Writes join_lattice(parts) without copying the masks. Throws as join_lattice() does.
void write_lattice(std::ostream& out, std::span<const LatticePart> parts);

// Opened lazily: shapes, sizes and numbers of blocks are checked, the masks when they are read. An
// edge to a blocked node, out of the lattice, or of another connectivity is refused with InputError
// then.
Lattice read_lattice(const geom::ArrayArchive& archive);

// The content of the file, for an archive that holds more: meta.json, and the arrays, which stay
// valid while the lattice lives.
std::string lattice_meta(const Lattice& lattice);
std::vector<geom::NamedArray> lattice_arrays(const Lattice& lattice);
Lattice read_lattice(const geom::ArrayArchive& archive, std::string_view meta_json);

bool is_lattice(const geom::ArrayArchive& archive);  // whether the archive says so

// What meta.json says of a lattice, for one whose masks stand elsewhere.
struct LatticeMeta {
  LatticeGrid grid;
  LatticeCounts counts;
  geom::Provenance made_for;
};
std::string lattice_meta(const LatticeMeta& lattice);
LatticeMeta read_lattice_meta(const geom::JsonFields& fields);

// The counts that the file gives; counted if it gives none.
LatticeCounts stored_counts(const Lattice& lattice);

void verify_lattice(const Lattice& lattice);  // every bit; InputError where one is wrong

}  // namespace plan
