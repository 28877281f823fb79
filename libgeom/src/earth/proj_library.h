#pragma once

// The functions of PROJ, which is loaded when it is first needed.

#include <proj.h>

namespace geom {

struct ProjLibrary {
  decltype(&proj_context_create) context_create;
  decltype(&proj_context_destroy) context_destroy;
  decltype(&proj_context_set_enable_network) enable_network;
  decltype(&proj_context_use_proj4_init_rules) use_init_rules;
  decltype(&proj_log_level) log_level;
  decltype(&proj_create) create;
  decltype(&proj_clone) clone;
  decltype(&proj_destroy) destroy;
  decltype(&proj_get_type) type_of;
  decltype(&proj_get_name) name_of;
  decltype(&proj_get_area_of_use) area_of;
  decltype(&proj_get_id_auth_name) authority_of;
  decltype(&proj_get_id_code) code_of;
  decltype(&proj_is_crs) is_crs;
  decltype(&proj_is_deprecated) is_deprecated;
  decltype(&proj_is_equivalent_to) is_equivalent;
  decltype(&proj_get_non_deprecated) replacements;
  decltype(&proj_list_get_count) list_count;
  decltype(&proj_list_get) list_get;
  decltype(&proj_list_destroy) list_destroy;
  decltype(&proj_crs_get_sub_crs) part;
  decltype(&proj_get_source_crs) source_of;
  decltype(&proj_crs_get_coordinate_system) axes;
  decltype(&proj_cs_get_axis_count) axis_count;
  decltype(&proj_cs_get_axis_info) axis_info;
  decltype(&proj_crs_get_coordoperation) conversion;
  decltype(&proj_coordoperation_get_method_info) method_info;
  decltype(&proj_create_crs_to_crs_from_pj) way;
  decltype(&proj_normalize_for_visualization) normalize;
  decltype(&proj_as_proj_string) text_of;
  decltype(&proj_trans_generic) transform;
};

// Loads it at the first call. Throws std::runtime_error where PROJ is not installed.
const ProjLibrary& proj();

}  // namespace geom
