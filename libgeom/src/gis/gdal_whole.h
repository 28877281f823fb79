#pragma once

// Files that GDAL reads in part and says nothing of it (gdal_*.cpp only).

#include <cstddef>
#include <string>
#include <vector>

#include "gdal_handles.h"
#include "geom/base/error.h"

namespace geom::gis {

// Throws InputError(name, …) where the file at `path`, which `dataset` was opened from, says
// itself that it is a part, or holds what GDAL passes over: GeoJSON that its server cut or with a
// key twice, KML that leads to other files, shapefiles whose parts do not belong together or that
// have rows marked as deleted. Throws it for a format that is not known to be read whole, as DXF.
// Returns how many features must come of it at least.
std::size_t require_whole(const DatasetHandle& dataset, const std::string& path,
                          const std::string& name);

// The same of a shapefile: `path` is its .shp.
void require_whole_shapefile(const DatasetHandle& dataset, const std::string& name);

// The text of a KML file; of a KMZ those of all KML files in it, of which GDAL reads one.
std::vector<std::string> kml_texts(const std::string& path, const std::string& name);

// Paths of the files beside `path` that `dataset` is read from: of a shapefile its index, table and
// reference system.
std::vector<std::string> files_beside(const DatasetHandle& dataset, const std::string& path);

// What to say of a file that GDAL did not open.
Fault unopened(const std::string& path);

}  // namespace geom::gis
