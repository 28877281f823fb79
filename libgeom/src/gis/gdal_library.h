#pragma once

// The functions of GDAL's C interface, which is loaded when it is first needed.

#include <cpl_conv.h>
#include <gdal.h>
#include <ogr_api.h>
#include <ogr_srs_api.h>

namespace geom::gis {

struct GdalLibrary {
  decltype(&GDALAllRegister) all_register;
  decltype(&CPLGetLastErrorMsg) last_error;
  decltype(&CPLPushErrorHandler) push_error_handler;
  decltype(&CPLQuietErrorHandler) quiet_error_handler;
  decltype(&CPLSetConfigOption) set_option;
  decltype(&GDALOpenEx) open;
  decltype(&GDALClose) close;
  decltype(&GDALGetDriverByName) driver_named;
  decltype(&GDALCreate) create;
  decltype(&GDALGetRasterXSize) raster_width;
  decltype(&GDALGetRasterYSize) raster_height;
  decltype(&GDALGetRasterCount) raster_count;
  decltype(&GDALGetRasterBand) raster_band;
  decltype(&GDALRasterIO) raster_io;
  decltype(&GDALGetRasterNoDataValue) no_data;
  decltype(&GDALSetRasterNoDataValue) set_no_data;
  decltype(&GDALGetRasterDataType) data_type;
  decltype(&GDALGetRasterScale) raster_scale;
  decltype(&GDALGetRasterOffset) raster_offset;
  decltype(&GDALSetDescription) set_description;
  decltype(&GDALSetMetadataItem) set_metadata_item;
  decltype(&GDALGetGeoTransform) geo_transform;
  decltype(&GDALSetGeoTransform) set_geo_transform;
  decltype(&GDALInvGeoTransform) invert_geo_transform;
  decltype(&GDALGetSpatialRef) spatial_reference;
  decltype(&GDALSetSpatialRef) set_spatial_reference;
  decltype(&OSRNewSpatialReference) new_reference;
  decltype(&OSRDestroySpatialReference) destroy_reference;
  decltype(&OSRClone) clone_reference;
  decltype(&OSRSetFromUserInput) reference_from_text;
  decltype(&OSRSetAxisMappingStrategy) set_axis_mapping;
  decltype(&OCTNewCoordinateTransformation) new_transformation;
  decltype(&OCTDestroyCoordinateTransformation) destroy_transformation;
  decltype(&OCTTransform) transform;
  decltype(&GDALDatasetCreateLayer) create_layer;
  decltype(&GDALDatasetGetLayerByName) layer_named;
  decltype(&OGR_L_CreateField) create_field;
  decltype(&OGR_L_GetLayerDefn) layer_definition;
  decltype(&OGR_L_CreateFeature) create_feature;
  decltype(&OGR_L_GetNextFeature) next_feature;
  decltype(&OGR_L_StartTransaction) start_transaction;
  decltype(&OGR_L_CommitTransaction) commit_transaction;
  decltype(&OGR_F_Create) new_feature;
  decltype(&OGR_F_Destroy) destroy_feature;
  decltype(&OGR_F_SetFieldString) set_text;
  decltype(&OGR_F_SetFieldDouble) set_number;
  decltype(&OGR_F_GetGeometryRef) geometry_of;
  decltype(&OGR_F_SetGeometryDirectly) set_geometry;
  decltype(&OGR_Fld_Create) new_field;
  decltype(&OGR_Fld_Destroy) destroy_field;
  decltype(&OGR_G_CreateGeometry) new_geometry;
  decltype(&OGR_G_AddPoint) add_point;
  decltype(&OGR_G_AddGeometryDirectly) add_geometry;
  decltype(&OGR_G_GetGeometryRef) part_of;
  decltype(&OGR_G_GetPointCount) point_count;
  decltype(&OGR_G_GetPoint) point;
};

// Loads it at the first call. Throws std::runtime_error where GDAL is not installed. GDAL says
// nothing on stderr by itself.
const GdalLibrary& gdal();

}  // namespace geom::gis
