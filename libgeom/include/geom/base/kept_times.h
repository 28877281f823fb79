#pragma once

// File systems on which a file cannot change without a change of its times.
//
// Example:
//   assert(geom::keeps_times(0xEF53));   // ext4
//   assert(!geom::keeps_times(0x4D44));  // FAT: a copy with the old time (cp -p) looks unchanged

#include <cstdint>
#include <string>

namespace geom {

// Of the file system of this path; false if it cannot be asked.
bool keeps_times(const std::string& path);

// Of a kind as statfs(2) names it. True for kinds whose kernel notes the time of each change of a
// file, so that no program can set it back. A file keeps its number there. False for FAT and exFAT,
// which have no such time, and for FUSE, SMB and 9p, whose other side may make it up. False for
// media that may be exchanged, and for memory, where a write through a mapping leaves no time.
// False for unknown kinds.
bool keeps_times(std::uint32_t kind);

}  // namespace geom
