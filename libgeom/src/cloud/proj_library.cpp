#include "proj_library.h"

#include "geom/base/loaded_library.h"

namespace geom {
namespace {

ProjLibrary load() {
  const LoadedLibrary library(SKYWAY_PROJ_SONAME, "libproj25");
  return {.context_create = SKYWAY_FUNCTION(library, proj_context_create),
          .context_destroy = SKYWAY_FUNCTION(library, proj_context_destroy),
          .log_level = SKYWAY_FUNCTION(library, proj_log_level),
          .enable_network = SKYWAY_FUNCTION(library, proj_context_set_enable_network),
          .create = SKYWAY_FUNCTION(library, proj_create),
          .clone = SKYWAY_FUNCTION(library, proj_clone),
          .destroy = SKYWAY_FUNCTION(library, proj_destroy),
          .type_of = SKYWAY_FUNCTION(library, proj_get_type),
          .name_of = SKYWAY_FUNCTION(library, proj_get_name),
          .is_crs = SKYWAY_FUNCTION(library, proj_is_crs),
          .part = SKYWAY_FUNCTION(library, proj_crs_get_sub_crs),
          .source_of = SKYWAY_FUNCTION(library, proj_get_source_crs),
          .axes = SKYWAY_FUNCTION(library, proj_crs_get_coordinate_system),
          .axis_count = SKYWAY_FUNCTION(library, proj_cs_get_axis_count),
          .axis_info = SKYWAY_FUNCTION(library, proj_cs_get_axis_info),
          .conversion = SKYWAY_FUNCTION(library, proj_crs_get_coordoperation),
          .method_info = SKYWAY_FUNCTION(library, proj_coordoperation_get_method_info),
          .way = SKYWAY_FUNCTION(library, proj_create_crs_to_crs_from_pj),
          .normalize = SKYWAY_FUNCTION(library, proj_normalize_for_visualization),
          .transform = SKYWAY_FUNCTION(library, proj_trans_generic),
          .transform_bounds = SKYWAY_FUNCTION(library, proj_trans_bounds)};
}

}  // namespace

const ProjLibrary& proj() {
  static const ProjLibrary library = load();
  return library;
}

}  // namespace geom
