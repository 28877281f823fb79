#pragma once

// The functions of GDAL's C interface, which is loaded when it is first needed.

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal.h>
#include <ogr_api.h>
#include <ogr_srs_api.h>

#include "base/watched_sqlite.h"
#include "geom/base/loaded_library.h"

namespace geom::gis {

struct GdalLibrary {
  LoadedLibrary library;
  bool watches_sqlite = watch_sqlite(library);
  SKYWAY_LOADED(all_register, GDALAllRegister);
  SKYWAY_LOADED(last_error, CPLGetLastErrorMsg);
  SKYWAY_LOADED(last_error_type, CPLGetLastErrorType);
  SKYWAY_LOADED(forget_errors, CPLErrorReset);
  SKYWAY_LOADED(set_error_handler, CPLSetErrorHandler);
  SKYWAY_LOADED(quiet_error_handler, CPLQuietErrorHandler);
  SKYWAY_LOADED(option, CPLGetConfigOption);
  SKYWAY_LOADED(set_option, CPLSetConfigOption);
  SKYWAY_LOADED(set_option_of_thread, CPLSetThreadLocalConfigOption);
  SKYWAY_LOADED(extension_of, CPLGetExtension);
  SKYWAY_LOADED(with_extension, CPLResetExtension);
  SKYWAY_LOADED(stem_of, CPLGetBasename);
  SKYWAY_LOADED(name_of, CPLGetFilename);
  SKYWAY_LOADED(destroy_list, CSLDestroy);
  SKYWAY_LOADED(open_file, VSIFOpenL);
  SKYWAY_LOADED(close_file, VSIFCloseL);
  SKYWAY_LOADED(read_file, VSIFReadL);
  SKYWAY_LOADED(seek, VSIFSeekL);
  SKYWAY_LOADED(tell, VSIFTellL);
  SKYWAY_LOADED(stat, VSIStatL);
  SKYWAY_LOADED(read_whole, VSIIngestFile);
  SKYWAY_LOADED(free, VSIFree);
  SKYWAY_LOADED(list_files, VSIReadDirRecursive);
  SKYWAY_LOADED(file_in_memory, VSIFileFromMemBuffer);
  SKYWAY_LOADED(remove, VSIUnlink);
  SKYWAY_LOADED(identify, GDALIdentifyDriverEx);
  SKYWAY_LOADED(open, GDALOpenEx);
  SKYWAY_LOADED(close, GDALClose);
  SKYWAY_LOADED(files_of, GDALGetFileList);
  SKYWAY_LOADED(driver_of, GDALGetDatasetDriver);
  SKYWAY_LOADED(driver_name, GDALGetDriverShortName);
  SKYWAY_LOADED(driver_named, GDALGetDriverByName);
  SKYWAY_LOADED(create, GDALCreate);
  SKYWAY_LOADED(raster_width, GDALGetRasterXSize);
  SKYWAY_LOADED(raster_height, GDALGetRasterYSize);
  SKYWAY_LOADED(raster_count, GDALGetRasterCount);
  SKYWAY_LOADED(raster_band, GDALGetRasterBand);
  SKYWAY_LOADED(raster_io, GDALRasterIO);
  SKYWAY_LOADED(coverage, GDALGetDataCoverageStatus);
  SKYWAY_LOADED(block_size, GDALGetBlockSize);
  SKYWAY_LOADED(mask_flags, GDALGetMaskFlags);
  SKYWAY_LOADED(mask_of, GDALGetMaskBand);
  SKYWAY_LOADED(colour_meaning, GDALGetRasterColorInterpretation);
  SKYWAY_LOADED(no_data, GDALGetRasterNoDataValue);
  SKYWAY_LOADED(set_no_data, GDALSetRasterNoDataValue);
  SKYWAY_LOADED(data_type, GDALGetRasterDataType);
  SKYWAY_LOADED(raster_scale, GDALGetRasterScale);
  SKYWAY_LOADED(raster_offset, GDALGetRasterOffset);
  SKYWAY_LOADED(raster_unit, GDALGetRasterUnitType);
  SKYWAY_LOADED(set_description, GDALSetDescription);
  SKYWAY_LOADED(metadata, GDALGetMetadata);
  SKYWAY_LOADED(set_metadata_item, GDALSetMetadataItem);
  SKYWAY_LOADED(geo_transform, GDALGetGeoTransform);
  SKYWAY_LOADED(set_geo_transform, GDALSetGeoTransform);
  SKYWAY_LOADED(invert_geo_transform, GDALInvGeoTransform);
  SKYWAY_LOADED(spatial_reference, GDALGetSpatialRef);
  SKYWAY_LOADED(set_spatial_reference, GDALSetSpatialRef);
  SKYWAY_LOADED(new_reference, OSRNewSpatialReference);
  SKYWAY_LOADED(destroy_reference, OSRDestroySpatialReference);
  SKYWAY_LOADED(reference_from_text, OSRSetFromUserInput);
  SKYWAY_LOADED(set_axis_mapping, OSRSetAxisMappingStrategy);
  SKYWAY_LOADED(reference_to_text, OSRExportToWkt);
  SKYWAY_LOADED(is_same_reference, OSRIsSameEx);
  SKYWAY_LOADED(create_layer, GDALDatasetCreateLayer);
  SKYWAY_LOADED(layer_named, GDALDatasetGetLayerByName);
  SKYWAY_LOADED(layer_count, GDALDatasetGetLayerCount);
  SKYWAY_LOADED(layer, GDALDatasetGetLayer);
  SKYWAY_LOADED(execute_sql, GDALDatasetExecuteSQL);
  SKYWAY_LOADED(release_result, GDALDatasetReleaseResultSet);
  SKYWAY_LOADED(create_field, OGR_L_CreateField);
  SKYWAY_LOADED(layer_definition, OGR_L_GetLayerDefn);
  SKYWAY_LOADED(layer_name, OGR_L_GetName);
  SKYWAY_LOADED(layer_reference, OGR_L_GetSpatialRef);
  SKYWAY_LOADED(feature_count, OGR_L_GetFeatureCount);
  SKYWAY_LOADED(set_filter, OGR_L_SetAttributeFilter);
  SKYWAY_LOADED(rewind, OGR_L_ResetReading);
  SKYWAY_LOADED(layer_field_index, OGR_FD_GetFieldIndex);
  SKYWAY_LOADED(layer_geometry_count, OGR_FD_GetGeomFieldCount);
  SKYWAY_LOADED(layer_field_count, OGR_FD_GetFieldCount);
  SKYWAY_LOADED(layer_field, OGR_FD_GetFieldDefn);
  SKYWAY_LOADED(create_feature, OGR_L_CreateFeature);
  SKYWAY_LOADED(next_feature, OGR_L_GetNextFeature);
  SKYWAY_LOADED(start_transaction, OGR_L_StartTransaction);
  SKYWAY_LOADED(commit_transaction, OGR_L_CommitTransaction);
  SKYWAY_LOADED(new_feature, OGR_F_Create);
  SKYWAY_LOADED(destroy_feature, OGR_F_Destroy);
  SKYWAY_LOADED(set_text, OGR_F_SetFieldString);
  SKYWAY_LOADED(set_number, OGR_F_SetFieldDouble);
  SKYWAY_LOADED(geometry_of, OGR_F_GetGeometryRef);
  SKYWAY_LOADED(geometry_count, OGR_F_GetGeomFieldCount);
  SKYWAY_LOADED(geometry_at, OGR_F_GetGeomFieldRef);
  SKYWAY_LOADED(set_geometry, OGR_F_SetGeometryDirectly);
  SKYWAY_LOADED(feature_id, OGR_F_GetFID);
  SKYWAY_LOADED(field_count, OGR_F_GetFieldCount);
  SKYWAY_LOADED(field_index, OGR_F_GetFieldIndex);
  SKYWAY_LOADED(field, OGR_F_GetFieldDefnRef);
  SKYWAY_LOADED(is_field_set, OGR_F_IsFieldSetAndNotNull);
  SKYWAY_LOADED(integer, OGR_F_GetFieldAsInteger);
  SKYWAY_LOADED(text, OGR_F_GetFieldAsString);
  SKYWAY_LOADED(new_field, OGR_Fld_Create);
  SKYWAY_LOADED(destroy_field, OGR_Fld_Destroy);
  SKYWAY_LOADED(field_name, OGR_Fld_GetNameRef);
  SKYWAY_LOADED(field_type, OGR_Fld_GetType);
  SKYWAY_LOADED(field_subtype, OGR_Fld_GetSubType);
  SKYWAY_LOADED(new_geometry, OGR_G_CreateGeometry);
  SKYWAY_LOADED(destroy_geometry, OGR_G_DestroyGeometry);
  SKYWAY_LOADED(geometry_reference, OGR_G_GetSpatialReference);
  SKYWAY_LOADED(geometry_type, OGR_G_GetGeometryType);
  SKYWAY_LOADED(flat_type, OGR_GT_Flatten);
  SKYWAY_LOADED(is_subclass, OGR_GT_IsSubClassOf);
  SKYWAY_LOADED(type_name, OGRGeometryTypeToName);
  SKYWAY_LOADED(is_empty, OGR_G_IsEmpty);
  SKYWAY_LOADED(has_arcs, OGR_G_HasCurveGeometry);
  SKYWAY_LOADED(is_3d, OGR_G_Is3D);
  SKYWAY_LOADED(envelope, OGR_G_GetEnvelope3D);
  SKYWAY_LOADED(without_arcs, OGR_G_GetLinearGeometry);
  SKYWAY_LOADED(force_to_polygons, OGR_G_ForceToMultiPolygon);
  SKYWAY_LOADED(part_count, OGR_G_GetGeometryCount);
  SKYWAY_LOADED(add_point, OGR_G_AddPoint);
  SKYWAY_LOADED(add_geometry, OGR_G_AddGeometryDirectly);
  SKYWAY_LOADED(part_of, OGR_G_GetGeometryRef);
  SKYWAY_LOADED(point_count, OGR_G_GetPointCount);
  SKYWAY_LOADED(point, OGR_G_GetPoint);
  SKYWAY_LOADED(points, OGR_G_GetPoints);
};

// Loads it at the first call. Throws std::runtime_error where GDAL is not installed. GDAL says
// nothing on stderr by itself.
const GdalLibrary& gdal();

}  // namespace geom::gis
