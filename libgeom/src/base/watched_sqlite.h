#pragma once

// SQLite's failed allocations, which its users take for an answer without rows.

#include "geom/base/loaded_library.h"

namespace geom {

// From now on WatchedMemory counts the failed allocations of the SQLite that `user` works with.
// Call it as soon as `user` is loaded, because SQLite takes a log only before its first use.
// Returns false if the process has used SQLite before, or if `user` holds a SQLite of its own.
bool watch_sqlite(const LoadedLibrary& user);

}  // namespace geom
