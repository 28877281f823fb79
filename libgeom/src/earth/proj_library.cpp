#include "proj_library.h"

#include "geom/base/loaded_library.h"

namespace geom {
namespace {

ProjLibrary load() {
  const LoadedLibrary library(SKYWAY_PROJ_SONAME, "libproj25");
  return {.context_create = SKYWAY_FUNCTION(library, proj_context_create),
          .context_destroy = SKYWAY_FUNCTION(library, proj_context_destroy),
          .enable_network = SKYWAY_FUNCTION(library, proj_context_set_enable_network),
          .use_init_rules = SKYWAY_FUNCTION(library, proj_context_use_proj4_init_rules),
          .log_level = SKYWAY_FUNCTION(library, proj_log_level),
          .create = SKYWAY_FUNCTION(library, proj_create),
          .clone = SKYWAY_FUNCTION(library, proj_clone),
          .destroy = SKYWAY_FUNCTION(library, proj_destroy),
          .type_of = SKYWAY_FUNCTION(library, proj_get_type),
          .name_of = SKYWAY_FUNCTION(library, proj_get_name),
          .area_of = SKYWAY_FUNCTION(library, proj_get_area_of_use),
          .authority_of = SKYWAY_FUNCTION(library, proj_get_id_auth_name),
          .code_of = SKYWAY_FUNCTION(library, proj_get_id_code),
          .is_crs = SKYWAY_FUNCTION(library, proj_is_crs),
          .is_deprecated = SKYWAY_FUNCTION(library, proj_is_deprecated),
          .is_equivalent = SKYWAY_FUNCTION(library, proj_is_equivalent_to),
          .replacements = SKYWAY_FUNCTION(library, proj_get_non_deprecated),
          .list_count = SKYWAY_FUNCTION(library, proj_list_get_count),
          .list_get = SKYWAY_FUNCTION(library, proj_list_get),
          .list_destroy = SKYWAY_FUNCTION(library, proj_list_destroy),
          .part = SKYWAY_FUNCTION(library, proj_crs_get_sub_crs),
          .source_of = SKYWAY_FUNCTION(library, proj_get_source_crs),
          .axes = SKYWAY_FUNCTION(library, proj_crs_get_coordinate_system),
          .axis_count = SKYWAY_FUNCTION(library, proj_cs_get_axis_count),
          .axis_info = SKYWAY_FUNCTION(library, proj_cs_get_axis_info),
          .conversion = SKYWAY_FUNCTION(library, proj_crs_get_coordoperation),
          .method_info = SKYWAY_FUNCTION(library, proj_coordoperation_get_method_info),
          .way = SKYWAY_FUNCTION(library, proj_create_crs_to_crs_from_pj),
          .normalize = SKYWAY_FUNCTION(library, proj_normalize_for_visualization),
          .text_of = SKYWAY_FUNCTION(library, proj_as_proj_string),
          .transform = SKYWAY_FUNCTION(library, proj_trans_generic)};
}

}  // namespace

const ProjLibrary& proj() {
  static const ProjLibrary library = load();
  return library;
}

}  // namespace geom
