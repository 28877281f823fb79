#pragma once

// An Embree scene over closed boxes. It only proposes candidates, in single precision relative to a
// near corner and with bounds padded past every rounding; callbacks decide each in double.

#include <embree3/rtcore.h>

#include <memory>
#include <span>
#include <type_traits>

#include "geom/shape/aabb.h"

namespace geom {

struct EmbreeRelease {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using EmbreeScene = std::unique_ptr<std::remove_pointer_t<RTCScene>, EmbreeRelease>;
using EmbreeGeometry = std::unique_ptr<std::remove_pointer_t<RTCGeometry>, EmbreeRelease>;

struct EmbreeBoxes {
  EmbreeScene scene;
  Vec3 corner = Vec3::Zero();  // the origin of the scene's coordinates
  Aabb extent;                 // the bounding box of the boxes
  Aabb reach;                  // that, plus what queries may stick out
  double pad = 0;              // what the bounds given to Embree exceed the boxes by, in metres
};

// The process's one device, which is never released: memory that runs out while Embree starts or
// stops leaves what all its devices share in disorder, so it does either at most once. Throws where
// it did not start.
RTCDevice embree_device();

// The scene of `boxes`, of which there is at least one; Embree then calls these for candidates.
// They must not throw: Embree would end the query as if there were no more candidates. Throws what
// went wrong inside Embree, which as a C library keeps that to itself.
EmbreeBoxes build(std::span<const Aabb> boxes, RTCOccludedFunctionN occluded,
                  RTCPointQueryFunction near);

// Whether the callback marks a candidate on the segment as hit. `context` is the first member of
// what the callback is given.
bool occluded(const EmbreeBoxes& boxes, const Vec3& a, const Vec3& b, RTCIntersectContext& context);

// What a ball around `p` must be larger by in single precision, in metres.
double slack_at(const EmbreeBoxes& boxes, const Vec3& p);

// Gives the callback the candidates in the ball, whose `radius` has the slack in it.
void near(const EmbreeBoxes& boxes, const Vec3& p, double radius, void* context);

void mark_hit(const RTCOccludedFunctionNArguments* args) noexcept;

}  // namespace geom
