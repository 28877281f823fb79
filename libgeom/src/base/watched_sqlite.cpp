#include "base/watched_sqlite.h"

#include <algorithm>
#include <mutex>
#include <vector>

#include "base/watched_memory.h"

namespace geom {
namespace {

// Of SQLite's documentation: its header is not needed for these.
using Configure = int(int option, ...);
using Initialize = int();
constexpr int kLog = 16;      // SQLITE_CONFIG_LOG
constexpr int kDone = 0;      // SQLITE_OK
constexpr int kNoMemory = 7;  // SQLITE_NOMEM, the lowest byte of a code

// SQLite's allocator logs each allocation that failed.
void note(void*, int code, const char*) {
  if ((code & 0xff) == kNoMemory) note_failed_allocation();
}

}  // namespace

bool watch_sqlite(const LoadedLibrary& user) {
  static std::mutex guard;
  static std::vector<Configure*> watched;  // GDAL and PROJ share one
  Configure* const configure = user.used_function("sqlite3_config");
  Initialize* const initialize = user.used_function("sqlite3_initialize");
  if (!configure || !initialize) return false;
  const std::lock_guard lock(guard);
  if (std::find(watched.begin(), watched.end(), configure) != watched.end()) return true;
  watched.reserve(watched.size() + 1);
  if (configure(kLog, &note, nullptr) != kDone) return false;
  watched.push_back(configure);
  initialize();  // so that PROJ sets no log of its own, as PROJ_LOG_SQLITE3 makes it do
  return true;
}

}  // namespace geom
