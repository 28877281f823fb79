#include "gdal_library.h"

#include "geom/base/loaded_library.h"

namespace geom::gis {
namespace {

GdalLibrary load() {
  const LoadedLibrary library(SKYWAY_GDAL_SONAME, "libgdal32");
  return {.all_register = library.function("GDALAllRegister"),
          .last_error = library.function("CPLGetLastErrorMsg"),
          .push_error_handler = library.function("CPLPushErrorHandler"),
          .quiet_error_handler = library.function("CPLQuietErrorHandler"),
          .set_option = library.function("CPLSetConfigOption"),
          .open = library.function("GDALOpenEx"),
          .close = library.function("GDALClose"),
          .driver_named = library.function("GDALGetDriverByName"),
          .create = library.function("GDALCreate"),
          .raster_width = library.function("GDALGetRasterXSize"),
          .raster_height = library.function("GDALGetRasterYSize"),
          .raster_count = library.function("GDALGetRasterCount"),
          .raster_band = library.function("GDALGetRasterBand"),
          .raster_io = library.function("GDALRasterIO"),
          .no_data = library.function("GDALGetRasterNoDataValue"),
          .set_no_data = library.function("GDALSetRasterNoDataValue"),
          .data_type = library.function("GDALGetRasterDataType"),
          .raster_scale = library.function("GDALGetRasterScale"),
          .raster_offset = library.function("GDALGetRasterOffset"),
          .set_description = library.function("GDALSetDescription"),
          .set_metadata_item = library.function("GDALSetMetadataItem"),
          .geo_transform = library.function("GDALGetGeoTransform"),
          .set_geo_transform = library.function("GDALSetGeoTransform"),
          .invert_geo_transform = library.function("GDALInvGeoTransform"),
          .spatial_reference = library.function("GDALGetSpatialRef"),
          .set_spatial_reference = library.function("GDALSetSpatialRef"),
          .new_reference = library.function("OSRNewSpatialReference"),
          .destroy_reference = library.function("OSRDestroySpatialReference"),
          .clone_reference = library.function("OSRClone"),
          .reference_from_text = library.function("OSRSetFromUserInput"),
          .set_axis_mapping = library.function("OSRSetAxisMappingStrategy"),
          .new_transformation = library.function("OCTNewCoordinateTransformation"),
          .destroy_transformation = library.function("OCTDestroyCoordinateTransformation"),
          .transform = library.function("OCTTransform"),
          .create_layer = library.function("GDALDatasetCreateLayer"),
          .layer_named = library.function("GDALDatasetGetLayerByName"),
          .create_field = library.function("OGR_L_CreateField"),
          .layer_definition = library.function("OGR_L_GetLayerDefn"),
          .create_feature = library.function("OGR_L_CreateFeature"),
          .next_feature = library.function("OGR_L_GetNextFeature"),
          .start_transaction = library.function("OGR_L_StartTransaction"),
          .commit_transaction = library.function("OGR_L_CommitTransaction"),
          .new_feature = library.function("OGR_F_Create"),
          .destroy_feature = library.function("OGR_F_Destroy"),
          .set_text = library.function("OGR_F_SetFieldString"),
          .set_number = library.function("OGR_F_SetFieldDouble"),
          .geometry_of = library.function("OGR_F_GetGeometryRef"),
          .set_geometry = library.function("OGR_F_SetGeometryDirectly"),
          .new_field = library.function("OGR_Fld_Create"),
          .destroy_field = library.function("OGR_Fld_Destroy"),
          .new_geometry = library.function("OGR_G_CreateGeometry"),
          .add_point = library.function("OGR_G_AddPoint"),
          .add_geometry = library.function("OGR_G_AddGeometryDirectly"),
          .part_of = library.function("OGR_G_GetGeometryRef"),
          .point_count = library.function("OGR_G_GetPointCount"),
          .point = library.function("OGR_G_GetPoint")};
}

GdalLibrary prepared(GdalLibrary library) {
  library.push_error_handler(library.quiet_error_handler);
  library.set_option("OGR_CURRENT_DATE", "2000-01-01T00:00:00Z");  // the same bytes at any time
  library.all_register();
  return library;
}

}  // namespace

const GdalLibrary& gdal() {
  static const GdalLibrary library = prepared(load());
  return library;
}

}  // namespace geom::gis
