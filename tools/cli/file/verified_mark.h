#pragma once

// Remembers which state of a map's file was verified, and how far, so that it is read once. Marks
// are small files in the user's own cache, never beside the map: who sends a map sends no mark.

#include <cstdint>
#include <string>

#include "geom/base/mapped_file.h"
#include "geom/map/box_map.h"

namespace cli {

// How far this state of a file with this ArrayArchive::directory_hash() was verified: nothing where
// there is no mark of both, or one that cannot be read, is malformed, belongs to another user or
// could be written by one.
geom::Verified marked(const geom::FileState& file, const std::string& directory);

// Leaves a mark, in place of an older one of that file. Quietly not where there is no cache to
// write to, where `path` is no longer in this state, or where it could change again without a
// difference in its times: it changed so recently, or its file system does not keep them
// (geom/base/kept_times.h). At most some hundred marks are kept. `now` is in nanoseconds since
// 1970.
void mark(const std::string& path, const geom::FileState& file, const std::string& directory,
          geom::Verified level, std::int64_t now);

std::int64_t clock_now();  // by the system's clock

}  // namespace cli
