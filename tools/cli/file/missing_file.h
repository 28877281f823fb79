#pragma once

// What to do where a file or folder that was named is not there, or is a folder.

#include <string>

#include "geom/base/file_error.h"

namespace cli {

// What to add to the refusal of a file that could not be opened: the file of a similar name in its
// folder, the folder to make, or that a file is needed. Nothing where that is not what is wrong.
std::string missing_file_advice(const geom::FileError& error);

}  // namespace cli
