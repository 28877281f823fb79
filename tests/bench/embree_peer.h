#pragma once

// Embree alone beside the collision structure: one scene over all grown boxes as user geometry,
// each candidate decided in double by the functions of geom. Single precision, with padded bounds.
//
// Embree asks for what is in a sphere, but inside of an instance whose axes are scaled apart, for
// what meets the box around what the sphere becomes there. So a second scene has the first one as
// an instance, in which a ball of radius 1 has the half sizes of the regions.

#include <embree3/rtcore.h>

#include <algorithm>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

#include "geom/base/rounding.h"
#include "peer_frame.h"

namespace bench {

class EmbreePeer {
 public:
  // All regions have these half sizes.
  EmbreePeer(std::span<const Aabb> boxes, const Vec3& half)
      : boxes_(boxes), frame_(boxes), half_(half + Vec3::Constant(frame_.pad())) {
    device_ = rtcNewDevice("threads=1");
    scene_ = rtcNewScene(device_);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    const RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(boxes.size()));
    rtcSetGeometryUserData(geometry, this);
    rtcSetGeometryBoundsFunction(geometry, bounds_of, nullptr);
    rtcSetGeometryOccludedFunction(geometry, decide_hit);
    rtcSetGeometryPointQueryFunction(geometry, decide);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
    scaled_ = rtcNewScene(device_);
    const RTCGeometry instance = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_INSTANCE);
    rtcSetGeometryInstancedScene(instance, scene_);
    const Eigen::Vector3f scale = half_.cwiseInverse().cast<float>();
    const float columns[12] = {scale[0], 0, 0, 0, scale[1], 0, 0, 0, scale[2], 0, 0, 0};
    rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns);
    rtcCommitGeometry(instance);
    rtcAttachGeometry(scaled_, instance);
    rtcReleaseGeometry(instance);
    rtcCommitScene(scaled_);
    if (rtcGetDeviceError(device_) != RTC_ERROR_NONE) throw std::runtime_error("Embree failed");
  }
  ~EmbreePeer() {
    rtcReleaseScene(scaled_);
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  EmbreePeer(const EmbreePeer&) = delete;
  EmbreePeer& operator=(const EmbreePeer&) = delete;

  bool hits(const Vec3& a, const Vec3& b) const {
    Segment segment{{}, this, a, b};
    rtcInitIntersectContext(&segment.rtc);
    const Eigen::Vector3f from = frame_.at(a);
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
    Near near{this, p, std::numeric_limits<double>::infinity()};
    ask(scene_, frame_.at(p), std::numeric_limits<float>::infinity(), &near);
    return near.best;
  }

  std::vector<std::size_t> boxes_meeting(const Aabb& region) const {
    Meeting meeting{this, region, {}};
    meeting.found.reserve(kFew);
    const Vec3 centre = 0.5 * (region.min + region.max);
    ask(scaled_, frame_.at(centre).cwiseQuotient(half_.cast<float>()), 1, &meeting);
    std::sort(meeting.found.begin(), meeting.found.end());
    return meeting.found;
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
  };
  struct Meeting {
    const EmbreePeer* peer;
    const Aabb& region;
    std::vector<std::size_t> found;
  };

  static void ask(RTCScene scene, const Eigen::Vector3f& at, float radius, void* question) {
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    RTCPointQuery query{at[0], at[1], at[2], 0, radius};
    rtcPointQuery(scene, &query, &context, nullptr, question);
  }

  static void bounds_of(const RTCBoundsFunctionArguments* args) {
    const auto& peer = *static_cast<const EmbreePeer*>(args->geometryUserPtr);
    const Aabb& box = peer.boxes_[args->primID];
    RTCBounds& out = *args->bounds_o;
    out.lower_x = peer.frame_.low(box, 0);
    out.lower_y = peer.frame_.low(box, 1);
    out.lower_z = peer.frame_.low(box, 2);
    out.upper_x = peer.frame_.high(box, 0);
    out.upper_y = peer.frame_.high(box, 1);
    out.upper_z = peer.frame_.high(box, 2);
  }

  static void decide_hit(const RTCOccludedFunctionNArguments* args) {
    if (!args->valid[0]) return;
    const auto& segment = *reinterpret_cast<const Segment*>(args->context);
    if (geom::segment_hits(segment.a, segment.b, segment.peer->boxes_[args->primID])) {
      RTCRayN_tfar(args->ray, args->N, 0) = -std::numeric_limits<float>::infinity();
    }
  }

  // Of both scenes. Only in the scaled one is there a transformation.
  static bool decide(RTCPointQueryFunctionArguments* args) {
    return args->context->instStackSize > 0 ? decide_meeting(args) : decide_near(args);
  }

  static bool decide_meeting(RTCPointQueryFunctionArguments* args) {
    auto& meeting = *static_cast<Meeting*>(args->userPtr);
    const Aabb& box = meeting.peer->boxes_[args->primID];
    if (geom::overlap(meeting.region, box)) meeting.found.push_back(args->primID);
    return false;
  }

  static bool decide_near(RTCPointQueryFunctionArguments* args) {
    auto& near = *static_cast<Near*>(args->userPtr);
    const double distance = geom::distance(near.p, near.peer->boxes_[args->primID]);
    if (distance >= near.best) return false;
    near.best = distance;
    args->query->radius = geom::float_up(distance + 2 * near.peer->frame_.pad());
    return true;
  }

  std::span<const Aabb> boxes_;
  PeerFrame frame_;
  Vec3 half_;  // of a region, and the pad
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
  RTCScene scaled_ = nullptr;
};

}  // namespace bench
