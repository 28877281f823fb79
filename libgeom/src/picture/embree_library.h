#pragma once

// Embree's functions for pictures; Embree is loaded when the first is needed.

#include <embree3/rtcore.h>

namespace geom::picture {

struct EmbreeLibrary {
  decltype(&rtcNewDevice) new_device;
  decltype(&rtcReleaseDevice) release_device;
  decltype(&rtcGetDeviceError) device_error;
  decltype(&rtcGetDeviceProperty) device_property;
  decltype(&rtcNewScene) new_scene;
  decltype(&rtcReleaseScene) release_scene;
  decltype(&rtcSetSceneFlags) set_scene_flags;
  decltype(&rtcCommitScene) commit_scene;
  decltype(&rtcNewGeometry) new_geometry;
  decltype(&rtcReleaseGeometry) release_geometry;
  decltype(&rtcSetNewGeometryBuffer) set_new_geometry_buffer;
  decltype(&rtcCommitGeometry) commit_geometry;
  decltype(&rtcAttachGeometryByID) attach_geometry;
  decltype(&rtcIntersect16) intersect16;
  decltype(&rtcOccluded16) occluded16;
};

// Throws what LoadedLibrary throws, each time. Threads may call at once.
const EmbreeLibrary& embree();

}  // namespace geom::picture
