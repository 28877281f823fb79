#pragma once

// The formats that footprints, city models and height models come in.
//
// Example:
//   for (const geom::gis::FootprintFormat* one : geom::gis::footprint_formats()) {
//     std::cout << one->format->word << '\n';
//   }
//
// The readers are in read_footprints.h, which needs further libraries; this table does not.

#include "geom/base/format.h"

namespace geom::gis {

struct FootprintFormat {
  const Format* format;
  Formats kinds = {};  // files of this format that have names of their own
};

// Polygons in a format of GDAL, OpenStreetMap, CityJSON, CityGML, height models.
FormatRows<FootprintFormat> footprint_formats();

extern const FootprintFormat kVector;
extern const FootprintFormat kOsm;
extern const FootprintFormat kCityJson;
extern const FootprintFormat kCityGml;
extern const FootprintFormat kRaster;

// Kinds of kVector that other tools read, too.
extern const Format kGeoJsonFile;
extern const Format kGeoJsonFeature;  // one feature alone
extern const Format kKmlFile;

// A kind of kOsm that its name tells: .osm.gz or .osm.bz2.
extern const Format kPackedOsm;
bool is_packed_osm(std::string_view path);

}  // namespace geom::gis
