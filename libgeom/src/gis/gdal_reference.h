#pragma once

// The reference systems that a file names (gdal_*.cpp only). Where GDAL understands
// none it says nothing, and numbers would count as metres.

#include <string>

#include "gdal_handles.h"
#include "gml_told.h"

namespace geom::gis {

// Throws InputError(name, …) where a layer has no reference system although the file, its .prj or
// its text (`gml`) names one, or GDAL complained since its errors were last forgotten. So forget
// them before the dataset is opened from `path`.
void require_known_references(const DatasetHandle& dataset, const std::string& path,
                              const GmlTold& gml, const std::string& name);

// The same of the .prj of a raster.
void require_known_raster_reference(const DatasetHandle& dataset, const std::string& path,
                                    const std::string& name);

// Whether a geometry has the reference system of its layer, or none of its own.
bool has_reference_of(OGRGeometryH geometry, OGRLayerH layer);

}  // namespace geom::gis
