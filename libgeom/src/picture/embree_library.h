#pragma once

// Embree's functions for pictures; Embree is loaded when the first is needed.

#include <embree3/rtcore.h>

#include "geom/base/loaded_library.h"

namespace geom::picture {

struct EmbreeLibrary {
  LoadedLibrary library;
  SKYWAY_LOADED(new_device, rtcNewDevice);
  SKYWAY_LOADED(release_device, rtcReleaseDevice);
  SKYWAY_LOADED(device_error, rtcGetDeviceError);
  SKYWAY_LOADED(device_property, rtcGetDeviceProperty);
  SKYWAY_LOADED(new_scene, rtcNewScene);
  SKYWAY_LOADED(release_scene, rtcReleaseScene);
  SKYWAY_LOADED(set_scene_flags, rtcSetSceneFlags);
  SKYWAY_LOADED(commit_scene, rtcCommitScene);
  SKYWAY_LOADED(new_geometry, rtcNewGeometry);
  SKYWAY_LOADED(release_geometry, rtcReleaseGeometry);
  SKYWAY_LOADED(set_new_geometry_buffer, rtcSetNewGeometryBuffer);
  SKYWAY_LOADED(commit_geometry, rtcCommitGeometry);
  SKYWAY_LOADED(attach_geometry, rtcAttachGeometryByID);
  SKYWAY_LOADED(intersect16, rtcIntersect16);
  SKYWAY_LOADED(occluded16, rtcOccluded16);
};

// Throws what LoadedLibrary throws, each time. Threads may call at once.
const EmbreeLibrary& embree();

}  // namespace geom::picture
