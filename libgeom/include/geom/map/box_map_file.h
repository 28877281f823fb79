#pragma once

// Box map files (`.boxmap`): ZIPs of NumPy arrays, described in docs/formats.md.
//
// Example:
//   const geom::BoxMap city = geom::open_map("city.boxmap");  // mapped, neither read nor copied
//   city.require(geom::Verified::contents);                   // looks at every byte
//   std::ostringstream out;
//   geom::write_box_map(out, city);

#include <iosfwd>
#include <string>

#include "geom/archive/array_archive.h"
#include "geom/map/box_map.h"

namespace geom {

void write_box_map(std::ostream& out, const BoxMap& map);

// Views the archive's arrays, without copying the boxes. Checks the directory, shapes, types and
// tile ranges; throws InputError otherwise. The rest is verified when BoxMap says. `known`: what
// the caller has verified before of this very state of the file.
BoxMap read_box_map(const ArrayArchive& archive, Verified known = Verified::nothing);

// The map in a file, which is mapped and neither read nor copied. Throws std::system_error if it
// cannot be mapped, and InputError as read_box_map does.
BoxMap open_map(const std::string& path);

// Throws std::runtime_error if the file of the map was written to or cut since it was opened: an
// answer about the map may then be of neither state. A program that keeps a map open for long calls
// this after an answer, before somebody relies on it. A new file that takes the name does no harm.
// Cheap: asks the system for the file's times.
void require_unchanged(const BoxMap& map);

// Whether the archive says that it is a box map.
bool is_box_map(const ArrayArchive& archive);

}  // namespace geom
