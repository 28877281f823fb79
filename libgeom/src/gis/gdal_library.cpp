#include "gdal_library.h"

#include <fmt/format.h>

#include "geom/base/error.h"
#include "geom/base/usage_error.h"

namespace geom::gis {
namespace {

// GDAL's options that make it read another height, place or outline than the file has, or none.
// Anybody may have set them for another program: in the environment, or in a gdalrc.
constexpr const char* kReadOtherwise[] = {"AAIGRID_DATATYPE",
                                          "ATTRIBUTES_SKIP",
                                          "GDAL_GEOREF_SOURCES",
                                          "GEOMETRY_AS_COLLECTION",
                                          "GML_ATTRIBUTES_TO_OGR_FIELDS",
                                          "GML_CONSIDER_EPSG_AS_URN",
                                          "GML_FACE_HOLE_NEGATIVE",
                                          "GML_FETCH_ALL_GEOMETRIES",
                                          "GML_FIELDTYPES",
                                          "GML_GET_SECONDARY_GEOM",
                                          "GML_GFS_TEMPLATE",
                                          "GML_INVERT_AXIS_ORDER_IF_LAT_LONG",
                                          "GML_READ_MODE",
                                          "GML_REGISTRY",
                                          "GML_SKIP_CORRUPTED_FEATURES",
                                          "GML_SKIP_RESOLVE_ELEMS",
                                          "GML_SRS_DIMENSION_IF_MISSING",
                                          "GML_SWAP_COORDINATES",
                                          "GTIFF_HONOUR_NEGATIVE_SCALEY",
                                          "GTIFF_IGNORE_READ_ERRORS",
                                          "GTIFF_LINEAR_UNITS",
                                          "GTIFF_POINT_GEO_IGNORE",
                                          "GTIFF_SRS_SOURCE",
                                          "OGR_ARC_MAX_GAP",
                                          "OGR_ARC_STEPSIZE",
                                          "OGR_CT_FORCE_TRADITIONAL_GIS_ORDER",
                                          "OGR_ORGANIZE_POLYGONS",
                                          "OGR_SQLITE_LOAD_EXTENSIONS",
                                          "OGR_SQLITE_PRAGMA",
                                          "OGR_STROKE_CURVE",
                                          "OSR_DEFAULT_AXIS_MAPPING_STRATEGY",
                                          "SHAPE_2GB_LIMIT",
                                          "SHAPE_RESTORE_SHX"};

void refuse_reading_otherwise(const GdalLibrary& library) {
  for (const char* const name : kReadOtherwise) {
    const char* const value = library.option(name, nullptr);
    if (!value) continue;
    throw UsageError(fmt::format(
        "the option {} of GDAL is set to {}, so that it would read files in another way: "
        "unset it in the environment, or take it out of GDAL's configuration file",
        name, in_quotes(value)));
  }
}

GdalLibrary prepared(GdalLibrary library) {
  library.set_error_handler(library.quiet_error_handler);
  library.all_register();  // reads GDAL's configuration file
  refuse_reading_otherwise(library);
  library.set_option("GDAL_DISABLE_READDIR_ON_OPEN", "NO");        // files beside one belong to it
  library.set_option("GDAL_PAM_ENABLED", "YES");                   // the same
  library.set_option("OGR_CURRENT_DATE", "2000-01-01T00:00:00Z");  // the same bytes at any time
  library.set_option("GTIFF_REPORT_COMPD_CS", "YES");  // heights or depths, of all versions
  return library;
}

}  // namespace

const GdalLibrary& gdal() {
  static const GdalLibrary library = prepared({LoadedLibrary(SKYWAY_GDAL_SONAME, "libgdal32")});
  return library;
}

}  // namespace geom::gis
