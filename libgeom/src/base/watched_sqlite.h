#pragma once

// SQLite's failed allocations, which its users take for an answer without rows.

#include "geom/base/loaded_library.h"

namespace geom {

// Has the failed allocations of the SQLite that `user` works with counted by WatchedMemory, until
// the process ends. To be called as soon as `user` is loaded: SQLite takes its log before it is
// first used. Returns false if the process has used SQLite before, or if `user` has its own within.
bool watch_sqlite(const LoadedLibrary& user);

}  // namespace geom
