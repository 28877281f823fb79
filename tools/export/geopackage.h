#pragma once

// --format gpkg: all flights of a stream in one GeoPackage, for QGIS.

#include <span>

#include "exporter.h"

namespace exporting {

// Each flight is proved as a file of straight lines (geojson) and, if it has times and the map a
// height, as volumes of airspace, too. Where any is refused stderr says so, there is no file, and
// the answer is no.
cli::Exit export_geopackage(const cli::Common& common, const Options& options, Exporter& exporter,
                            std::span<const Flight> flights);

}  // namespace exporting
