#include "gdal_library.h"

#include <fmt/format.h>

#include "geom/base/error.h"
#include "geom/base/loaded_library.h"
#include "geom/base/usage_error.h"

namespace geom::gis {
namespace {

GdalLibrary load() {
  const LoadedLibrary library(SKYWAY_GDAL_SONAME, "libgdal32");
  return {.all_register = SKYWAY_FUNCTION(library, GDALAllRegister),
          .last_error = SKYWAY_FUNCTION(library, CPLGetLastErrorMsg),
          .last_error_type = SKYWAY_FUNCTION(library, CPLGetLastErrorType),
          .forget_errors = SKYWAY_FUNCTION(library, CPLErrorReset),
          .set_error_handler = SKYWAY_FUNCTION(library, CPLSetErrorHandler),
          .quiet_error_handler = SKYWAY_FUNCTION(library, CPLQuietErrorHandler),
          .option = SKYWAY_FUNCTION(library, CPLGetConfigOption),
          .set_option = SKYWAY_FUNCTION(library, CPLSetConfigOption),
          .set_option_of_thread = SKYWAY_FUNCTION(library, CPLSetThreadLocalConfigOption),
          .extension_of = SKYWAY_FUNCTION(library, CPLGetExtension),
          .with_extension = SKYWAY_FUNCTION(library, CPLResetExtension),
          .stem_of = SKYWAY_FUNCTION(library, CPLGetBasename),
          .name_of = SKYWAY_FUNCTION(library, CPLGetFilename),
          .destroy_list = SKYWAY_FUNCTION(library, CSLDestroy),
          .open_file = SKYWAY_FUNCTION(library, VSIFOpenL),
          .close_file = SKYWAY_FUNCTION(library, VSIFCloseL),
          .read_file = SKYWAY_FUNCTION(library, VSIFReadL),
          .seek = SKYWAY_FUNCTION(library, VSIFSeekL),
          .tell = SKYWAY_FUNCTION(library, VSIFTellL),
          .stat = SKYWAY_FUNCTION(library, VSIStatL),
          .read_whole = SKYWAY_FUNCTION(library, VSIIngestFile),
          .free = SKYWAY_FUNCTION(library, VSIFree),
          .list_files = SKYWAY_FUNCTION(library, VSIReadDirRecursive),
          .file_in_memory = SKYWAY_FUNCTION(library, VSIFileFromMemBuffer),
          .remove = SKYWAY_FUNCTION(library, VSIUnlink),
          .identify = SKYWAY_FUNCTION(library, GDALIdentifyDriverEx),
          .open = SKYWAY_FUNCTION(library, GDALOpenEx),
          .close = SKYWAY_FUNCTION(library, GDALClose),
          .files_of = SKYWAY_FUNCTION(library, GDALGetFileList),
          .driver_of = SKYWAY_FUNCTION(library, GDALGetDatasetDriver),
          .driver_name = SKYWAY_FUNCTION(library, GDALGetDriverShortName),
          .driver_named = SKYWAY_FUNCTION(library, GDALGetDriverByName),
          .create = SKYWAY_FUNCTION(library, GDALCreate),
          .raster_width = SKYWAY_FUNCTION(library, GDALGetRasterXSize),
          .raster_height = SKYWAY_FUNCTION(library, GDALGetRasterYSize),
          .raster_count = SKYWAY_FUNCTION(library, GDALGetRasterCount),
          .raster_band = SKYWAY_FUNCTION(library, GDALGetRasterBand),
          .raster_io = SKYWAY_FUNCTION(library, GDALRasterIO),
          .coverage = SKYWAY_FUNCTION(library, GDALGetDataCoverageStatus),
          .block_size = SKYWAY_FUNCTION(library, GDALGetBlockSize),
          .mask_flags = SKYWAY_FUNCTION(library, GDALGetMaskFlags),
          .mask_of = SKYWAY_FUNCTION(library, GDALGetMaskBand),
          .colour_meaning = SKYWAY_FUNCTION(library, GDALGetRasterColorInterpretation),
          .no_data = SKYWAY_FUNCTION(library, GDALGetRasterNoDataValue),
          .set_no_data = SKYWAY_FUNCTION(library, GDALSetRasterNoDataValue),
          .data_type = SKYWAY_FUNCTION(library, GDALGetRasterDataType),
          .raster_scale = SKYWAY_FUNCTION(library, GDALGetRasterScale),
          .raster_offset = SKYWAY_FUNCTION(library, GDALGetRasterOffset),
          .raster_unit = SKYWAY_FUNCTION(library, GDALGetRasterUnitType),
          .set_description = SKYWAY_FUNCTION(library, GDALSetDescription),
          .metadata = SKYWAY_FUNCTION(library, GDALGetMetadata),
          .set_metadata_item = SKYWAY_FUNCTION(library, GDALSetMetadataItem),
          .geo_transform = SKYWAY_FUNCTION(library, GDALGetGeoTransform),
          .set_geo_transform = SKYWAY_FUNCTION(library, GDALSetGeoTransform),
          .invert_geo_transform = SKYWAY_FUNCTION(library, GDALInvGeoTransform),
          .spatial_reference = SKYWAY_FUNCTION(library, GDALGetSpatialRef),
          .set_spatial_reference = SKYWAY_FUNCTION(library, GDALSetSpatialRef),
          .new_reference = SKYWAY_FUNCTION(library, OSRNewSpatialReference),
          .destroy_reference = SKYWAY_FUNCTION(library, OSRDestroySpatialReference),
          .reference_from_text = SKYWAY_FUNCTION(library, OSRSetFromUserInput),
          .set_axis_mapping = SKYWAY_FUNCTION(library, OSRSetAxisMappingStrategy),
          .reference_to_text = SKYWAY_FUNCTION(library, OSRExportToWkt),
          .is_same_reference = SKYWAY_FUNCTION(library, OSRIsSameEx),
          .create_layer = SKYWAY_FUNCTION(library, GDALDatasetCreateLayer),
          .layer_named = SKYWAY_FUNCTION(library, GDALDatasetGetLayerByName),
          .layer_count = SKYWAY_FUNCTION(library, GDALDatasetGetLayerCount),
          .layer = SKYWAY_FUNCTION(library, GDALDatasetGetLayer),
          .execute_sql = SKYWAY_FUNCTION(library, GDALDatasetExecuteSQL),
          .release_result = SKYWAY_FUNCTION(library, GDALDatasetReleaseResultSet),
          .create_field = SKYWAY_FUNCTION(library, OGR_L_CreateField),
          .layer_definition = SKYWAY_FUNCTION(library, OGR_L_GetLayerDefn),
          .layer_name = SKYWAY_FUNCTION(library, OGR_L_GetName),
          .layer_reference = SKYWAY_FUNCTION(library, OGR_L_GetSpatialRef),
          .feature_count = SKYWAY_FUNCTION(library, OGR_L_GetFeatureCount),
          .set_filter = SKYWAY_FUNCTION(library, OGR_L_SetAttributeFilter),
          .rewind = SKYWAY_FUNCTION(library, OGR_L_ResetReading),
          .layer_field_index = SKYWAY_FUNCTION(library, OGR_FD_GetFieldIndex),
          .layer_geometry_count = SKYWAY_FUNCTION(library, OGR_FD_GetGeomFieldCount),
          .layer_field_count = SKYWAY_FUNCTION(library, OGR_FD_GetFieldCount),
          .layer_field = SKYWAY_FUNCTION(library, OGR_FD_GetFieldDefn),
          .create_feature = SKYWAY_FUNCTION(library, OGR_L_CreateFeature),
          .next_feature = SKYWAY_FUNCTION(library, OGR_L_GetNextFeature),
          .start_transaction = SKYWAY_FUNCTION(library, OGR_L_StartTransaction),
          .commit_transaction = SKYWAY_FUNCTION(library, OGR_L_CommitTransaction),
          .new_feature = SKYWAY_FUNCTION(library, OGR_F_Create),
          .destroy_feature = SKYWAY_FUNCTION(library, OGR_F_Destroy),
          .set_text = SKYWAY_FUNCTION(library, OGR_F_SetFieldString),
          .set_number = SKYWAY_FUNCTION(library, OGR_F_SetFieldDouble),
          .geometry_of = SKYWAY_FUNCTION(library, OGR_F_GetGeometryRef),
          .geometry_count = SKYWAY_FUNCTION(library, OGR_F_GetGeomFieldCount),
          .geometry_at = SKYWAY_FUNCTION(library, OGR_F_GetGeomFieldRef),
          .set_geometry = SKYWAY_FUNCTION(library, OGR_F_SetGeometryDirectly),
          .feature_id = SKYWAY_FUNCTION(library, OGR_F_GetFID),
          .field_count = SKYWAY_FUNCTION(library, OGR_F_GetFieldCount),
          .field_index = SKYWAY_FUNCTION(library, OGR_F_GetFieldIndex),
          .field = SKYWAY_FUNCTION(library, OGR_F_GetFieldDefnRef),
          .is_field_set = SKYWAY_FUNCTION(library, OGR_F_IsFieldSetAndNotNull),
          .integer = SKYWAY_FUNCTION(library, OGR_F_GetFieldAsInteger),
          .text = SKYWAY_FUNCTION(library, OGR_F_GetFieldAsString),
          .new_field = SKYWAY_FUNCTION(library, OGR_Fld_Create),
          .destroy_field = SKYWAY_FUNCTION(library, OGR_Fld_Destroy),
          .field_name = SKYWAY_FUNCTION(library, OGR_Fld_GetNameRef),
          .field_type = SKYWAY_FUNCTION(library, OGR_Fld_GetType),
          .field_subtype = SKYWAY_FUNCTION(library, OGR_Fld_GetSubType),
          .new_geometry = SKYWAY_FUNCTION(library, OGR_G_CreateGeometry),
          .destroy_geometry = SKYWAY_FUNCTION(library, OGR_G_DestroyGeometry),
          .geometry_reference = SKYWAY_FUNCTION(library, OGR_G_GetSpatialReference),
          .geometry_type = SKYWAY_FUNCTION(library, OGR_G_GetGeometryType),
          .flat_type = SKYWAY_FUNCTION(library, OGR_GT_Flatten),
          .is_subclass = SKYWAY_FUNCTION(library, OGR_GT_IsSubClassOf),
          .type_name = SKYWAY_FUNCTION(library, OGRGeometryTypeToName),
          .is_empty = SKYWAY_FUNCTION(library, OGR_G_IsEmpty),
          .has_arcs = SKYWAY_FUNCTION(library, OGR_G_HasCurveGeometry),
          .is_3d = SKYWAY_FUNCTION(library, OGR_G_Is3D),
          .envelope = SKYWAY_FUNCTION(library, OGR_G_GetEnvelope3D),
          .without_arcs = SKYWAY_FUNCTION(library, OGR_G_GetLinearGeometry),
          .force_to_polygons = SKYWAY_FUNCTION(library, OGR_G_ForceToMultiPolygon),
          .part_count = SKYWAY_FUNCTION(library, OGR_G_GetGeometryCount),
          .add_point = SKYWAY_FUNCTION(library, OGR_G_AddPoint),
          .add_geometry = SKYWAY_FUNCTION(library, OGR_G_AddGeometryDirectly),
          .part_of = SKYWAY_FUNCTION(library, OGR_G_GetGeometryRef),
          .point_count = SKYWAY_FUNCTION(library, OGR_G_GetPointCount),
          .point = SKYWAY_FUNCTION(library, OGR_G_GetPoint),
          .points = SKYWAY_FUNCTION(library, OGR_G_GetPoints)};
}

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
  static const GdalLibrary library = prepared(load());
  return library;
}

}  // namespace geom::gis
