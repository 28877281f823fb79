#pragma once

// Files that are neither sources of obstacles, nor drones' files, nor ours: who reads them, or what
// to do about them.

#include "geom/base/format.h"

namespace cli {

// More telling ones first: any XML and any ZIP archive come last.
geom::Formats foreign_formats();

extern const geom::Format kFenceText;  // fences or rally points in Mission Planner's words
extern const geom::Format kZip;        // a ZIP archive that nothing more is known of
extern const geom::Format kPx4Log;

}  // namespace cli
