#pragma once

// What a file is by its first bytes, whoever made it: the tables of formats, one after the other.
//
//   if (const geom::Format* format = cli::recognise_file(path)) say(format->what, format->readers);

#include <string>
#include <string_view>
#include <vector>

#include "geom/base/format.h"

namespace cli {

// Ours, then drones' files, then sources of obstacles by family, then all others. A format that
// several families read is there once for each.
std::vector<const geom::Format*> all_formats();

// Null where `head`, the beginning of a file, tells nothing. A hint for people, never a reason to
// read a file in one way or another.
const geom::Format* recognise(std::string_view head);

// Of a regular file by its first bytes or, where these tell nothing or that it is packed, by how
// its name ends. Null for what is not a regular file, so that nothing waits or is eaten.
const geom::Format* recognise_file(const std::string& path);

// The first bytes of a regular file; empty for what is not one.
std::string head_of(const std::string& path);

// What the format is, and of a ZIP archive that no table knows the name of its first entry:
// `a ZIP archive whose first entry is "a.txt"`.
std::string described(const geom::Format& format, std::string_view head);

}  // namespace cli
