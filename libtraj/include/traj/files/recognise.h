#pragma once

// What a file is by its first bytes, whoever made it: the tables of formats, one after the other.
//
// Example:
//   const geom::Format* format = traj::files::recognise("%PDF-1.7");
//   assert(format && format->what == "a PDF document" && format->readers.empty());

#include <string>
#include <string_view>
#include <vector>

#include "geom/base/format.h"

namespace traj::files {

// Ours, then drones' files, then sources of obstacles by family, then all others. A format that
// several families read is there once for each.
std::vector<const geom::Format*> all_formats();

// The format of a file that begins with `head`, its first geom::kFormatHead bytes. Null where that
// tells nothing. A hint for people, never a reason to read a file in one way or another.
const geom::Format* recognise(std::string_view head);

// The same, and where the bytes tell nothing, or only that the file is packed, by how `name` ends.
const geom::Format* recognise(std::string_view head, const std::string& name);

// What the format is, and of a ZIP archive that no table knows the name of its first entry:
// `a ZIP archive whose first entry is "a.txt"`.
std::string described(const geom::Format& format, std::string_view head);

}  // namespace traj::files
