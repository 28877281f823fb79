#pragma once

// Roadmap files (`.roadmap`): ZIPs of NumPy arrays (docs/formats.md).
//
// Example:
//   std::ostringstream out;
//   plan::write_roadmap(out, plan::build_roadmap(scene, {}));
//   const std::string bytes = out.str();
//   const plan::Roadmap roadmap = plan::read_roadmap(
//       geom::ArrayArchive::from_bytes(std::as_bytes(std::span(bytes)), "city.roadmap"));

#include <iosfwd>
#include <span>

#include "geom/archive/array_archive.h"
#include "plan/roadmap/roadmap.h"

namespace plan {

void write_roadmap(std::ostream& out, const Roadmap& roadmap);

// Writes the tiles of several parts of a roadmap, one part after the other: bit for bit what one
// run writes. No part is held in memory beyond its table of tiles. Throws geom::InputError where
// they are not of one roadmap, or their tiles do not ascend. There is at least one part.
void write_roadmap(std::ostream& out, std::span<const Roadmap> parts);

bool is_roadmap(const geom::ArrayArchive& archive);

// Throws geom::InputError for another kind of file and arrays of other lengths. Other errors
// are refused when a search meets them.
Roadmap read_roadmap(const geom::ArrayArchive& archive);

void verify_roadmap(const Roadmap& roadmap);  // every tile, bend and edge; InputError

}  // namespace plan
