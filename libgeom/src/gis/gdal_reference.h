#pragma once

// GDAL's spatial references, opened the same way everywhere (gdal_*.cpp only).

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <cmath>
#include <memory>
#include <string>

#include "geom/base/error.h"

namespace geom::gis {

struct DatasetCloser {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, DatasetCloser>;

// GDAL keeps a conversion that is closed in this way, and gives it to the next caller. PROJ would
// search for it again, which takes 10 ms.
struct ConversionCloser {
  void operator()(OGRCoordinateTransformation* conversion) const {
    OGRCoordinateTransformation::DestroyCT(conversion);
  }
};
using Conversion = std::unique_ptr<OGRCoordinateTransformation, ConversionCloser>;

// Null where PROJ knows none.
inline Conversion conversion(const OGRSpatialReference& from, const OGRSpatialReference& to) {
  return Conversion(OGRCreateCoordinateTransformation(&from, &to));
}

// Opens quietly; null where GDAL cannot.
inline Dataset open(const std::string& path, unsigned kind) {
  GDALAllRegister();
  CPLSetErrorHandler(CPLQuietErrorHandler);  // what it says goes into our own messages
  Dataset dataset(static_cast<GDALDataset*>(
      GDALOpenEx(path.c_str(), kind | GDAL_OF_READONLY, nullptr, nullptr, nullptr)));
  return dataset;
}

inline OGRSpatialReference reference(const std::string& crs, const std::string& name) {
  OGRSpatialReference out;
  CPLSetErrorHandler(CPLQuietErrorHandler);
  const OGRErr error = out.SetFromUserInput(crs.c_str());
  if (error != OGRERR_NONE) {
    throw InputError(name, {.expected = "a coordinate reference system that PROJ knows",
                            .found = in_quotes(crs.substr(0, 80))});
  }
  out.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return out;
}

// Empty for none and for a local one, whose units must be metres.
inline std::string wkt_of(const OGRSpatialReference* reference, const std::string& name) {
  if (!reference) return "";
  if (reference->IsLocal()) {
    const double unit = reference->GetLinearUnits();
    if (std::abs(unit - 1) > 1e-9) {
      throw InputError(name, {.expected = "local coordinates in metres",
                              .found = fmt::format("units of {} m", unit),
                              .advice = "convert them first"});
    }
    return "";
  }
  char* text = nullptr;
  reference->exportToWkt(&text);
  const std::string out = text ? text : "";
  CPLFree(text);
  return out;
}

}  // namespace geom::gis
