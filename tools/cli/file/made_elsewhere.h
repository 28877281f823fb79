#pragma once

// Files that a library writes by their path, as the bytes that an OutputFile takes.

#include <functional>
#include <string>

namespace cli {

// Calls write(path) for a new file of this ending, such as ".tif", in a folder of its own, and
// returns its bytes; the folder is gone afterwards. Throws std::system_error where there is no room
// for it.
std::string made_elsewhere(const std::string& ending,
                           const std::function<void(const std::string&)>& write);

}  // namespace cli
