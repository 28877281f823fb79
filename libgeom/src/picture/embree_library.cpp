#include "embree_library.h"

#include "geom/base/loaded_library.h"

namespace geom::picture {
namespace {

EmbreeLibrary load() {
  const LoadedLibrary library(SKYWAY_EMBREE_SONAME, "libembree3-3");
  return {.new_device = library.function("rtcNewDevice"),
          .release_device = library.function("rtcReleaseDevice"),
          .device_error = library.function("rtcGetDeviceError"),
          .device_property = library.function("rtcGetDeviceProperty"),
          .new_scene = library.function("rtcNewScene"),
          .release_scene = library.function("rtcReleaseScene"),
          .set_scene_flags = library.function("rtcSetSceneFlags"),
          .commit_scene = library.function("rtcCommitScene"),
          .new_geometry = library.function("rtcNewGeometry"),
          .release_geometry = library.function("rtcReleaseGeometry"),
          .set_new_geometry_buffer = library.function("rtcSetNewGeometryBuffer"),
          .commit_geometry = library.function("rtcCommitGeometry"),
          .attach_geometry = library.function("rtcAttachGeometryByID"),
          .intersect16 = library.function("rtcIntersect16"),
          .occluded16 = library.function("rtcOccluded16")};
}

}  // namespace

const EmbreeLibrary& embree() {
  static const EmbreeLibrary library = load();
  return library;
}

}  // namespace geom::picture
