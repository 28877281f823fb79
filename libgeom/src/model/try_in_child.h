#pragma once

// Libraries that may abort or crash on a hostile file.

#include <functional>
#include <string>

namespace geom {

// Calls `read` in a child process, which then ends whatever `read` gave or threw: who calls reads
// again for that. Throws std::runtime_error, which names the library and `source`, where a signal
// ended the child, and std::system_error where there can be no child. Call it before there are
// threads.
void try_in_child(const std::function<void()>& read, const std::string& library,
                  const std::string& source);

}  // namespace geom
