#pragma once

// What a file of the user is by its first bytes.
//
//   if (const geom::Format* format = cli::recognise_file(path)) say(format->what, format->readers);

#include <string>

#include "traj/files/recognise.h"

namespace cli {

// Of a regular file by its first bytes or, where these tell nothing or that it is packed, by how
// its name ends. Null for what is not a regular file, so that nothing waits or is eaten.
const geom::Format* recognise_file(const std::string& path);

// The first bytes of a regular file; empty for what is not one.
std::string head_of(const std::string& path);

}  // namespace cli
