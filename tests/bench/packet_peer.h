#pragma once

// Embree alone beside the pictures: the depths of a frame by coherent packets of sixteen rays, all
// in single precision.

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

#include "geom/picture/view.h"

namespace bench {

using geom::Aabb;
using geom::Vec3;

class PacketPeer {
 public:
  // The ground is a plane at this height.
  PacketPeer(std::span<const Aabb> boxes, const Vec3& middle, double ground)
      : middle_(middle), ground_(static_cast<float>(ground - middle.z())) {
    device_ = rtcNewDevice("threads=1");
    scene_ = rtcNewScene(device_);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    const RTCGeometry quads = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_QUAD);
    auto* corner = static_cast<float*>(rtcSetNewGeometryBuffer(
        quads, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, 8 * boxes.size()));
    auto* face = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
        quads, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT4, 16, 6 * boxes.size()));
    constexpr unsigned kFaces[6][4] = {{0, 4, 6, 2}, {0, 1, 5, 4}, {0, 2, 3, 1},
                                       {1, 3, 7, 5}, {2, 6, 7, 3}, {4, 5, 7, 6}};
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (int k = 0; k < 8; ++k) {
        for (int axis = 0; axis < 3; ++axis) {
          const Vec3& side = k >> axis & 1 ? boxes[i].max : boxes[i].min;
          *corner++ = static_cast<float>(side[axis] - middle[axis]);
        }
      }
      for (const auto& f : kFaces) {
        for (const unsigned k : f) *face++ = static_cast<unsigned>(8 * i) + k;
      }
    }
    rtcCommitGeometry(quads);
    rtcAttachGeometry(scene_, quads);
    rtcReleaseGeometry(quads);
    rtcCommitScene(scene_);
    if (rtcGetDeviceError(device_) != RTC_ERROR_NONE) throw std::runtime_error("Embree failed");
  }
  ~PacketPeer() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  PacketPeer(const PacketPeer&) = delete;
  PacketPeer& operator=(const PacketPeer&) = delete;

  // Of a perspective view whose width and height are multiples of 32, in tiles of 32 x 32; 0 of the
  // sky.
  std::vector<float> depths(const geom::picture::View& view) const {
    std::vector<float> out(static_cast<std::size_t>(view.width * view.height));
    for (int y = 0; y < view.height; y += 32) {
      for (int x = 0; x < view.width; x += 32) {
        for (int k = 0; k < 64; ++k) cast(view, x + 4 * (k % 8), y + 4 * (k / 8), out.data());
      }
    }
    return out;
  }

 private:
  void cast(const geom::picture::View& view, int x, int y, float* out) const {
    alignas(64) RTCRayHit16 packet;
    alignas(64) std::array<int, 16> valid;
    valid.fill(-1);
    const Eigen::Vector3f eye = (view.eye - middle_).cast<float>();
    const Eigen::Vector3f right = (view.axes.col(0) / view.fx).cast<float>();
    const Eigen::Vector3f down = (view.axes.col(1) / view.fy).cast<float>();
    const Eigen::Vector3f corner = view.axes.col(2).cast<float>() +
                                   (static_cast<float>(x - view.cx) * right) +
                                   (static_cast<float>(y - view.cy) * down);
#pragma GCC unroll 16
    for (int i = 0; i < 16; ++i) {
      const auto u = static_cast<float>(i % 4);
      const auto v = static_cast<float>(i / 4);
      packet.ray.org_x[i] = eye.x();
      packet.ray.org_y[i] = eye.y();
      packet.ray.org_z[i] = eye.z();
      packet.ray.dir_x[i] = corner.x() + u * right.x() + v * down.x();
      packet.ray.dir_y[i] = corner.y() + u * right.y() + v * down.y();
      packet.ray.dir_z[i] = corner.z() + u * right.z() + v * down.z();
      packet.ray.tnear[i] = 1e-3f;
      packet.ray.tfar[i] = std::numeric_limits<float>::infinity();
      packet.ray.time[i] = 0;
      packet.ray.mask[i] = ~0u;
      packet.ray.id[i] = 0;
      packet.ray.flags[i] = 0;
      packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect16(valid.data(), scene_, &context, &packet);
    for (int i = 0; i < 16; ++i) {
      float depth = packet.ray.tfar[i];
      const float fall = (ground_ - eye.z()) / packet.ray.dir_z[i];
      if (fall > 0) depth = std::min(depth, fall);
      if (depth > std::numeric_limits<float>::max()) depth = 0;
      out[(y + i / 4) * view.width + x + i % 4] = depth;
    }
  }

  Vec3 middle_;
  float ground_;
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
};

}  // namespace bench
