#include "embree_library.h"

#include "geom/base/loaded_library.h"

namespace geom::picture {
namespace {

EmbreeLibrary load() {
  const LoadedLibrary library(SKYWAY_EMBREE_SONAME, "libembree3-3");
  return {.new_device = SKYWAY_FUNCTION(library, rtcNewDevice),
          .release_device = SKYWAY_FUNCTION(library, rtcReleaseDevice),
          .device_error = SKYWAY_FUNCTION(library, rtcGetDeviceError),
          .device_property = SKYWAY_FUNCTION(library, rtcGetDeviceProperty),
          .new_scene = SKYWAY_FUNCTION(library, rtcNewScene),
          .release_scene = SKYWAY_FUNCTION(library, rtcReleaseScene),
          .set_scene_flags = SKYWAY_FUNCTION(library, rtcSetSceneFlags),
          .commit_scene = SKYWAY_FUNCTION(library, rtcCommitScene),
          .new_geometry = SKYWAY_FUNCTION(library, rtcNewGeometry),
          .release_geometry = SKYWAY_FUNCTION(library, rtcReleaseGeometry),
          .set_new_geometry_buffer = SKYWAY_FUNCTION(library, rtcSetNewGeometryBuffer),
          .commit_geometry = SKYWAY_FUNCTION(library, rtcCommitGeometry),
          .attach_geometry = SKYWAY_FUNCTION(library, rtcAttachGeometryByID),
          .intersect16 = SKYWAY_FUNCTION(library, rtcIntersect16),
          .occluded16 = SKYWAY_FUNCTION(library, rtcOccluded16)};
}

}  // namespace

const EmbreeLibrary& embree() {
  static const EmbreeLibrary library = load();
  return library;
}

}  // namespace geom::picture
