#pragma once

// Changes of an SQLite database that stand beside it (gdal_*.cpp only).

#include <string>

namespace geom::gis {

// Throws InputError(path, …) where a journal with changes stands beside the file: a write-ahead
// log, or what is left of a change that was broken off. SQLite would write them into the file, or,
// where it must not, pass over them.
void require_no_journal(const std::string& path);

}  // namespace geom::gis
