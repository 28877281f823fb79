#pragma once

// Embree alone beside the collision structure: one scene over all grown boxes as user geometry,
// each candidate decided in double by the functions of geom. Single precision relative to a corner,
// with padded bounds, as docs/benchmarks.md says.

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

#include "geom/base/rounding.h"
#include "geom/collision/collision.h"

namespace bench {

using geom::Aabb;
using geom::Vec3;

class EmbreePeer {
 public:
  explicit EmbreePeer(std::span<const Aabb> boxes) : boxes_(boxes) {
    const Aabb all = *geom::bounds(boxes);
    corner_ = all.min;
    pad_ = std::max(4e-4, std::ldexp((all.max - all.min).maxCoeff(), -20));
    device_ = rtcNewDevice("threads=1");
    scene_ = rtcNewScene(device_);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(boxes.size()));
    rtcSetGeometryUserData(geometry, this);
    rtcSetGeometryBoundsFunction(geometry, bounds_of, nullptr);
    rtcSetGeometryOccludedFunction(geometry, decide_hit);
    rtcSetGeometryPointQueryFunction(geometry, decide_near);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
    if (rtcGetDeviceError(device_) != RTC_ERROR_NONE) throw std::runtime_error("Embree failed");
  }
  ~EmbreePeer() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  EmbreePeer(const EmbreePeer&) = delete;
  EmbreePeer& operator=(const EmbreePeer&) = delete;

  bool hits(const Vec3& a, const Vec3& b) const {
    Segment segment{{}, this, a, b};
    rtcInitIntersectContext(&segment.rtc);
    const Eigen::Vector3f from = (a - corner_).cast<float>();
    const Eigen::Vector3f along = (b - a).cast<float>();
    RTCRay ray{};
    ray.org_x = from[0];
    ray.org_y = from[1];
    ray.org_z = from[2];
    ray.dir_x = along[0];
    ray.dir_y = along[1];
    ray.dir_z = along[2];
    ray.tfar = 1;
    ray.mask = ~0u;
    rtcOccluded1(scene_, &segment.rtc, &ray);
    return ray.tfar < 0;
  }

  double nearest(const Vec3& p) const {
    Near near{this, p, std::numeric_limits<double>::infinity(), nullptr, {}};
    ask(p, std::numeric_limits<float>::infinity(), near);
    return near.best;
  }

  std::vector<std::size_t> boxes_meeting(const Aabb& region) const {
    Near near{this, 0.5 * (region.min + region.max), 0, &region, {}};
    ask(near.p, geom::float_up(0.5 * (region.max - region.min).norm() + pad_), near);
    std::sort(near.found.begin(), near.found.end());
    return near.found;
  }

 private:
  struct Segment {
    RTCIntersectContext rtc;  // the first member: Embree hands it on
    const EmbreePeer* peer;
    Vec3 a;
    Vec3 b;
  };
  struct Near {
    const EmbreePeer* peer;
    Vec3 p;
    double best;
    const Aabb* region;
    std::vector<std::size_t> found;
  };

  void ask(const Vec3& p, float radius, Near& near) const {
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    const Eigen::Vector3f at = (p - corner_).cast<float>();
    RTCPointQuery query{at[0], at[1], at[2], 0, radius};
    rtcPointQuery(scene_, &query, &context, nullptr, &near);
  }

  static void bounds_of(const RTCBoundsFunctionArguments* args) {
    const auto& peer = *static_cast<const EmbreePeer*>(args->geometryUserPtr);
    const Aabb& box = peer.boxes_[args->primID];
    const Vec3 low = box.min - peer.corner_ - Vec3::Constant(peer.pad_);
    const Vec3 high = box.max - peer.corner_ + Vec3::Constant(peer.pad_);
    RTCBounds& out = *args->bounds_o;
    out.lower_x = geom::float_down(low[0]);
    out.lower_y = geom::float_down(low[1]);
    out.lower_z = geom::float_down(low[2]);
    out.upper_x = geom::float_up(high[0]);
    out.upper_y = geom::float_up(high[1]);
    out.upper_z = geom::float_up(high[2]);
  }

  static void decide_hit(const RTCOccludedFunctionNArguments* args) {
    if (!args->valid[0]) return;
    const auto& segment = *reinterpret_cast<const Segment*>(args->context);
    if (geom::segment_hits(segment.a, segment.b, segment.peer->boxes_[args->primID])) {
      RTCRayN_tfar(args->ray, args->N, 0) = -std::numeric_limits<float>::infinity();
    }
  }

  static bool decide_near(RTCPointQueryFunctionArguments* args) {
    auto& near = *static_cast<Near*>(args->userPtr);
    const Aabb& box = near.peer->boxes_[args->primID];
    if (near.region) {
      if (geom::overlap(*near.region, box)) near.found.push_back(args->primID);
      return false;
    }
    const double distance = geom::distance(near.p, box);
    if (distance >= near.best) return false;
    near.best = distance;
    args->query->radius = geom::float_up(distance + 2 * near.peer->pad_);
    return true;
  }

  std::span<const Aabb> boxes_;
  Vec3 corner_;
  double pad_ = 0;
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
};

}  // namespace bench
