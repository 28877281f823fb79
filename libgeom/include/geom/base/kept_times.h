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

// Of a kind as statfs(2) names it. Its kernel keeps the time of the last change of each file by
// itself, so that no program can set it back, and gives a file a number that stays. Not those that
// keep no such time (FAT, exFAT), get it from another program or machine that may make it up (FUSE,
// SMB, 9p), are read from media that may be changed, or lie in memory, where what is written
// through a mapping leaves no time. Unknown kinds are none of these.
bool keeps_times(std::uint32_t kind);

}  // namespace geom
