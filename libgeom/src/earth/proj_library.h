#pragma once

// The functions of PROJ, which is loaded when it is first needed.

#include <proj.h>

#include "base/watched_sqlite.h"
#include "geom/base/loaded_library.h"

namespace geom {

struct ProjLibrary {
  LoadedLibrary library;
  bool watches_sqlite = watch_sqlite(library);
  SKYWAY_LOADED(context_create, proj_context_create);
  SKYWAY_LOADED(context_destroy, proj_context_destroy);
  SKYWAY_LOADED(enable_network, proj_context_set_enable_network);
  SKYWAY_LOADED(use_init_rules, proj_context_use_proj4_init_rules);
  SKYWAY_LOADED(log_level, proj_log_level);
  SKYWAY_LOADED(log_function, proj_log_func);
  SKYWAY_LOADED(create, proj_create);
  SKYWAY_LOADED(clone, proj_clone);
  SKYWAY_LOADED(destroy, proj_destroy);
  SKYWAY_LOADED(type_of, proj_get_type);
  SKYWAY_LOADED(name_of, proj_get_name);
  SKYWAY_LOADED(area_of, proj_get_area_of_use);
  SKYWAY_LOADED(authority_of, proj_get_id_auth_name);
  SKYWAY_LOADED(code_of, proj_get_id_code);
  SKYWAY_LOADED(is_crs, proj_is_crs);
  SKYWAY_LOADED(is_deprecated, proj_is_deprecated);
  SKYWAY_LOADED(is_equivalent, proj_is_equivalent_to);
  SKYWAY_LOADED(replacements, proj_get_non_deprecated);
  SKYWAY_LOADED(list_count, proj_list_get_count);
  SKYWAY_LOADED(list_get, proj_list_get);
  SKYWAY_LOADED(list_destroy, proj_list_destroy);
  SKYWAY_LOADED(part, proj_crs_get_sub_crs);
  SKYWAY_LOADED(source_of, proj_get_source_crs);
  SKYWAY_LOADED(axes, proj_crs_get_coordinate_system);
  SKYWAY_LOADED(axis_count, proj_cs_get_axis_count);
  SKYWAY_LOADED(axis_info, proj_cs_get_axis_info);
  SKYWAY_LOADED(conversion, proj_crs_get_coordoperation);
  SKYWAY_LOADED(method_info, proj_coordoperation_get_method_info);
  SKYWAY_LOADED(way, proj_create_crs_to_crs_from_pj);
  SKYWAY_LOADED(normalize, proj_normalize_for_visualization);
  SKYWAY_LOADED(text_of, proj_as_proj_string);
  SKYWAY_LOADED(transform, proj_trans_generic);
};

// Loads it at the first call. Throws std::runtime_error where PROJ is not installed.
const ProjLibrary& proj();

}  // namespace geom
