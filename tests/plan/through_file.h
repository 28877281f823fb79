#pragma once

// Parts of lattices and roadmaps, written to an archive of their own and read again.

#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "plan/lattice/part_file.h"
#include "plan/roadmap/part_file.h"

namespace plan {

// The archive, and its meta.
template <class Part>
std::pair<geom::ArrayArchive, std::string> archive_of(const Part& part) {
  const PartArrays arrays = arrays_of(part);
  std::ostringstream out;
  geom::write_array_archive(out, arrays.meta, arrays.arrays);
  const std::string text = out.str();
  return {geom::ArrayArchive::from_bytes(std::as_bytes(std::span(text)), "part"), arrays.meta};
}

// As bytes, to be compared.
inline std::vector<std::string> arrays_and_meta(const PartArrays& part) {
  std::vector<std::string> out = {part.meta};
  for (const geom::NamedArray& array : part.arrays) {
    out.push_back(array.name + array.dtype);
    for (const auto piece : array.pieces) {
      out.back().append(reinterpret_cast<const char*>(piece.data()), piece.size());
    }
  }
  return out;
}

inline LatticePart through_file(const LatticePart& part) {
  const auto [archive, meta] = archive_of(part);
  return read_lattice_part(archive, meta, part.shard);
}

inline Roadmap through_file(const Roadmap& part) {
  const auto [archive, meta] = archive_of(part);
  return read_roadmap_part(archive, meta);
}

}  // namespace plan
