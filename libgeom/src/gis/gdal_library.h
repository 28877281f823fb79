#pragma once

// The functions of GDAL's C interface, which is loaded when it is first needed.

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal.h>
#include <ogr_api.h>
#include <ogr_srs_api.h>

namespace geom::gis {

struct GdalLibrary {
  decltype(&GDALAllRegister) all_register;
  decltype(&CPLGetLastErrorMsg) last_error;
  decltype(&CPLGetLastErrorType) last_error_type;
  decltype(&CPLErrorReset) forget_errors;
  decltype(&CPLSetErrorHandler) set_error_handler;
  decltype(&CPLQuietErrorHandler) quiet_error_handler;
  decltype(&CPLGetConfigOption) option;
  decltype(&CPLSetConfigOption) set_option;
  decltype(&CPLSetThreadLocalConfigOption) set_option_of_thread;
  decltype(&CPLGetExtension) extension_of;
  decltype(&CPLResetExtension) with_extension;
  decltype(&CPLGetBasename) stem_of;
  decltype(&CPLGetFilename) name_of;
  decltype(&CSLDestroy) destroy_list;
  decltype(&VSIFOpenL) open_file;
  decltype(&VSIFCloseL) close_file;
  decltype(&VSIFReadL) read_file;
  decltype(&VSIFSeekL) seek;
  decltype(&VSIFTellL) tell;
  decltype(&VSIStatL) stat;
  decltype(&VSIIngestFile) read_whole;
  decltype(&VSIFree) free;
  decltype(&VSIReadDirRecursive) list_files;
  decltype(&VSIFileFromMemBuffer) file_in_memory;
  decltype(&VSIUnlink) remove;
  decltype(&GDALIdentifyDriverEx) identify;
  decltype(&GDALOpenEx) open;
  decltype(&GDALClose) close;
  decltype(&GDALGetFileList) files_of;
  decltype(&GDALGetDatasetDriver) driver_of;
  decltype(&GDALGetDriverShortName) driver_name;
  decltype(&GDALGetDriverByName) driver_named;
  decltype(&GDALCreate) create;
  decltype(&GDALGetRasterXSize) raster_width;
  decltype(&GDALGetRasterYSize) raster_height;
  decltype(&GDALGetRasterCount) raster_count;
  decltype(&GDALGetRasterBand) raster_band;
  decltype(&GDALRasterIO) raster_io;
  decltype(&GDALGetDataCoverageStatus) coverage;
  decltype(&GDALGetBlockSize) block_size;
  decltype(&GDALGetMaskFlags) mask_flags;
  decltype(&GDALGetMaskBand) mask_of;
  decltype(&GDALGetRasterColorInterpretation) colour_meaning;
  decltype(&GDALGetRasterNoDataValue) no_data;
  decltype(&GDALSetRasterNoDataValue) set_no_data;
  decltype(&GDALGetRasterDataType) data_type;
  decltype(&GDALGetRasterScale) raster_scale;
  decltype(&GDALGetRasterOffset) raster_offset;
  decltype(&GDALGetRasterUnitType) raster_unit;
  decltype(&GDALSetDescription) set_description;
  decltype(&GDALGetMetadata) metadata;
  decltype(&GDALSetMetadataItem) set_metadata_item;
  decltype(&GDALGetGeoTransform) geo_transform;
  decltype(&GDALSetGeoTransform) set_geo_transform;
  decltype(&GDALInvGeoTransform) invert_geo_transform;
  decltype(&GDALGetSpatialRef) spatial_reference;
  decltype(&GDALSetSpatialRef) set_spatial_reference;
  decltype(&OSRNewSpatialReference) new_reference;
  decltype(&OSRDestroySpatialReference) destroy_reference;
  decltype(&OSRSetFromUserInput) reference_from_text;
  decltype(&OSRSetAxisMappingStrategy) set_axis_mapping;
  decltype(&OSRExportToWkt) reference_to_text;
  decltype(&OSRIsSameEx) is_same_reference;
  decltype(&GDALDatasetCreateLayer) create_layer;
  decltype(&GDALDatasetGetLayerByName) layer_named;
  decltype(&GDALDatasetGetLayerCount) layer_count;
  decltype(&GDALDatasetGetLayer) layer;
  decltype(&GDALDatasetExecuteSQL) execute_sql;
  decltype(&GDALDatasetReleaseResultSet) release_result;
  decltype(&OGR_L_CreateField) create_field;
  decltype(&OGR_L_GetLayerDefn) layer_definition;
  decltype(&OGR_L_GetName) layer_name;
  decltype(&OGR_L_GetSpatialRef) layer_reference;
  decltype(&OGR_L_GetFeatureCount) feature_count;
  decltype(&OGR_L_SetAttributeFilter) set_filter;
  decltype(&OGR_L_ResetReading) rewind;
  decltype(&OGR_FD_GetFieldIndex) layer_field_index;
  decltype(&OGR_FD_GetGeomFieldCount) layer_geometry_count;
  decltype(&OGR_FD_GetFieldCount) layer_field_count;
  decltype(&OGR_FD_GetFieldDefn) layer_field;
  decltype(&OGR_L_CreateFeature) create_feature;
  decltype(&OGR_L_GetNextFeature) next_feature;
  decltype(&OGR_L_StartTransaction) start_transaction;
  decltype(&OGR_L_CommitTransaction) commit_transaction;
  decltype(&OGR_F_Create) new_feature;
  decltype(&OGR_F_Destroy) destroy_feature;
  decltype(&OGR_F_SetFieldString) set_text;
  decltype(&OGR_F_SetFieldDouble) set_number;
  decltype(&OGR_F_GetGeometryRef) geometry_of;
  decltype(&OGR_F_GetGeomFieldCount) geometry_count;
  decltype(&OGR_F_GetGeomFieldRef) geometry_at;
  decltype(&OGR_F_SetGeometryDirectly) set_geometry;
  decltype(&OGR_F_GetFID) feature_id;
  decltype(&OGR_F_GetFieldCount) field_count;
  decltype(&OGR_F_GetFieldIndex) field_index;
  decltype(&OGR_F_GetFieldDefnRef) field;
  decltype(&OGR_F_IsFieldSetAndNotNull) is_field_set;
  decltype(&OGR_F_GetFieldAsInteger) integer;
  decltype(&OGR_F_GetFieldAsString) text;
  decltype(&OGR_Fld_Create) new_field;
  decltype(&OGR_Fld_Destroy) destroy_field;
  decltype(&OGR_Fld_GetNameRef) field_name;
  decltype(&OGR_Fld_GetType) field_type;
  decltype(&OGR_Fld_GetSubType) field_subtype;
  decltype(&OGR_G_CreateGeometry) new_geometry;
  decltype(&OGR_G_DestroyGeometry) destroy_geometry;
  decltype(&OGR_G_GetSpatialReference) geometry_reference;
  decltype(&OGR_G_GetGeometryType) geometry_type;
  decltype(&OGR_GT_Flatten) flat_type;
  decltype(&OGR_GT_IsSubClassOf) is_subclass;
  decltype(&OGRGeometryTypeToName) type_name;
  decltype(&OGR_G_IsEmpty) is_empty;
  decltype(&OGR_G_HasCurveGeometry) has_arcs;
  decltype(&OGR_G_Is3D) is_3d;
  decltype(&OGR_G_GetEnvelope3D) envelope;
  decltype(&OGR_G_GetLinearGeometry) without_arcs;
  decltype(&OGR_G_ForceToMultiPolygon) force_to_polygons;
  decltype(&OGR_G_GetGeometryCount) part_count;
  decltype(&OGR_G_AddPoint) add_point;
  decltype(&OGR_G_AddGeometryDirectly) add_geometry;
  decltype(&OGR_G_GetGeometryRef) part_of;
  decltype(&OGR_G_GetPointCount) point_count;
  decltype(&OGR_G_GetPoint) point;
  decltype(&OGR_G_GetPoints) points;
};

// Loads it at the first call. Throws std::runtime_error where GDAL is not installed. GDAL says
// nothing on stderr by itself.
const GdalLibrary& gdal();

}  // namespace geom::gis
