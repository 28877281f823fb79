#pragma once

// An Embree scene over closed boxes. It only proposes candidates, in single precision relative to a
// near corner and with bounds padded past every rounding; callbacks decide each in double.

#include <embree3/rtcore.h>

#include <span>

#include "geom/aabb.h"

namespace geom {

struct EmbreeBoxes {
  RTCScene scene = nullptr;
  Vec3 corner = Vec3::Zero();  // the origin of the scene's coordinates
  Aabb extent;                 // the bounding box of the boxes
  Aabb reach;                  // that, plus what queries may stick out
  double pad = 0;              // what the bounds given to Embree exceed the boxes by, in metres

  EmbreeBoxes() = default;
  EmbreeBoxes(const EmbreeBoxes&) = delete;
  EmbreeBoxes& operator=(const EmbreeBoxes&) = delete;
  ~EmbreeBoxes() {
    if (scene) rtcReleaseScene(scene);
  }
};

// Throws what the device's last error says.
void throw_on_error(RTCDevice device);

// The scene of `boxes`, of which there is at least one; Embree then calls these for candidates.
void build(RTCDevice device, std::span<const Aabb> boxes, RTCOccludedFunctionN occluded,
           RTCPointQueryFunction near, EmbreeBoxes& out);

// Whether the callback marks a candidate on the segment as hit. `context` is the first member of
// what the callback is given.
bool occluded(const EmbreeBoxes& boxes, const Vec3& a, const Vec3& b, RTCIntersectContext& context);

// What a ball around `p` must be larger by in single precision, in metres.
double slack_at(const EmbreeBoxes& boxes, const Vec3& p);

// Gives the callback the candidates in the ball, whose `radius` has the slack in it.
void near(const EmbreeBoxes& boxes, const Vec3& p, double radius, void* context);

float float_up(double x);  // the least float >= x
void mark_hit(const RTCOccludedFunctionNArguments* args);

}  // namespace geom
