#pragma once

// The header of a LAS file: LAS 1.4 R15 (ASPRS 2019), table 3, and what older versions have of it.

#include <cstdint>
#include <istream>
#include <string_view>

#include "geom/base/vec3.h"

namespace geom {

struct LasHeader {
  std::size_t size = 0;
  std::uint32_t records = 0;        // variable length records before the points
  std::uint64_t later_records = 0;  // where those after the points start; 0: none
  std::uint32_t later_count = 0;
  std::uint64_t waveforms = 0;   // where they start; 0: not in this file
  bool well_known_text = false;  // is what describes the coordinates, not the keys
  std::uint32_t data = 0;        // where the points start
  std::size_t record = 0;        // bytes a point
  unsigned format = 0;
  bool compressed = false;  // LAZ
  std::uint64_t points = 0;
  Vec3 scale;
  Vec3 offset;

  // Formats 6 to 10 keep their class elsewhere.
  bool modern() const { return format >= 6; }
};

// Reads the header to its end. Throws InputError(source, …) where it is cut short, of a version or
// a point format not known, or contradicts itself.
LasHeader read_las_header(std::istream& in, std::string_view source);

}  // namespace geom
