#include "gdal_journal.h"

#include <fmt/format.h>

#include <algorithm>

#include "gdal_library.h"
#include "geom/base/error.h"

namespace geom::gis {
namespace {

// SQLite leaves an empty file, or one that begins with zeros, where there are no changes.
bool holds_changes(const std::string& journal) {
  VSIStatBufL about;
  if (gdal().stat(journal.c_str(), &about) != 0) return false;
  VSILFILE* const file = gdal().open_file(journal.c_str(), "rb");
  if (!file) return true;
  std::string head(8, '\0');
  gdal().read_file(head.data(), 1, head.size(), file);
  gdal().close_file(file);
  return std::any_of(head.begin(), head.end(), [](char c) { return c != '\0'; });
}

}  // namespace

void require_no_journal(const std::string& path) {
  for (const char* ending : {"-wal", "-journal"}) {
    if (!holds_changes(path + ending)) continue;
    throw InputError(
        path, {.expected = "a database without changes beside it",
               .found = fmt::format("some in {}{}", path, ending),
               .advice = "close the program that has it open, such as QGIS, or write them into it "
                         "with `sqlite3 FILE \"PRAGMA wal_checkpoint(TRUNCATE)\"`"});
  }
}

}  // namespace geom::gis
