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
    const Frame frame(view, middle_);
    for (int y = 0; y < view.height; y += 32) {
      for (int x = 0; x < view.width; x += 32) {
        for (int k = 0; k < 64; ++k) cast(frame, x + 4 * (k % 8), y + 4 * (k / 8), out.data());
      }
    }
    return out;
  }

 private:
  static constexpr std::array<float, 16> kColumn{0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
  static constexpr std::array<float, 16> kRow{0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};

  struct Frame {
    int width;
    Eigen::Vector3f eye;
    Eigen::Vector3f right;  // from pixel to pixel
    Eigen::Vector3f down;
    Eigen::Vector3f corner;  // the direction of the first pixel

    Frame(const geom::picture::View& view, const Vec3& middle)
        : width(view.width),
          eye((view.eye - middle).cast<float>()),
          right((view.axes.col(0) / view.fx).cast<float>()),
          down((view.axes.col(1) / view.fy).cast<float>()),
          corner(view.axes.col(2).cast<float>() - static_cast<float>(view.cx) * right -
                 static_cast<float>(view.cy) * down) {}
  };

  // One axis of the directions, from that of the first pixel.
  static void spread(float first, float right, float down, float* out) {
    for (std::size_t i = 0; i < 16; ++i) out[i] = first + kColumn[i] * right + kRow[i] * down;
  }

  void cast(const Frame& frame, int x, int y, float* out) const {
    alignas(64) RTCRayHit16 packet;
    alignas(64) static constexpr std::array<int, 16> kAll{-1, -1, -1, -1, -1, -1, -1, -1,
                                                          -1, -1, -1, -1, -1, -1, -1, -1};
    std::fill_n(packet.ray.org_x, 16, frame.eye.x());
    std::fill_n(packet.ray.org_y, 16, frame.eye.y());
    std::fill_n(packet.ray.org_z, 16, frame.eye.z());
    const Eigen::Vector3f first =
        frame.corner + static_cast<float>(x) * frame.right + static_cast<float>(y) * frame.down;
    spread(first[0], frame.right[0], frame.down[0], packet.ray.dir_x);
    spread(first[1], frame.right[1], frame.down[1], packet.ray.dir_y);
    spread(first[2], frame.right[2], frame.down[2], packet.ray.dir_z);
    std::fill_n(packet.ray.tnear, 16, 1e-3f);
    std::fill_n(packet.ray.tfar, 16, std::numeric_limits<float>::infinity());
    std::fill_n(packet.ray.time, 16, 0.0f);
    std::fill_n(packet.ray.mask, 16, ~0u);
    std::fill_n(packet.ray.id, 16, 0u);
    std::fill_n(packet.ray.flags, 16, 0u);
    std::fill_n(packet.hit.geomID, 16, RTC_INVALID_GEOMETRY_ID);
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect16(kAll.data(), scene_, &context, &packet);
    std::array<float, 16> depth;
    const float fall = ground_ - frame.eye.z();
    for (std::size_t i = 0; i < 16; ++i) {
      const float ground =
          packet.ray.dir_z[i] < 0 ? fall / packet.ray.dir_z[i] : packet.ray.tfar[i];
      const float least = std::min(packet.ray.tfar[i], ground);
      depth[i] = least > std::numeric_limits<float>::max() ? 0 : least;
    }
    for (int row = 0; row < 4; ++row) {
      std::copy_n(depth.begin() + 4 * row, 4, out + (y + row) * frame.width + x);
    }
  }

  Vec3 middle_;
  float ground_;
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
};

}  // namespace bench
