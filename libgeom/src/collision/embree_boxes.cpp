#include "embree_boxes.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>

#include "geom/base/rounding.h"

namespace geom {
namespace {

struct BoundsSource {  // what the bounds callback needs; lives on the stack during the build
  std::span<const Aabb> boxes;
  Vec3 corner;
  double pad;
};

void write_bounds(const RTCBoundsFunctionArguments* args) noexcept {
  const auto& source = *static_cast<const BoundsSource*>(args->geometryUserPtr);
  const Aabb& box = source.boxes[args->primID];
  const Vec3 low = box.min - source.corner;
  const Vec3 high = box.max - source.corner;
  RTCBounds& out = *args->bounds_o;
  out.lower_x = float_down(low[0] - source.pad);
  out.lower_y = float_down(low[1] - source.pad);
  out.lower_z = float_down(low[2] - source.pad);
  out.upper_x = float_up(high[0] + source.pad);
  out.upper_y = float_up(high[1] + source.pad);
  out.upper_z = float_up(high[2] + source.pad);
}

[[noreturn]] void throw_error(RTCError error) {
  switch (error) {
    case RTC_ERROR_OUT_OF_MEMORY:
      throw std::bad_alloc();
    case RTC_ERROR_UNSUPPORTED_CPU:
      throw std::runtime_error("Embree does not support this processor");
    default:
      throw std::runtime_error("Embree could not build the collision structure");
  }
}

// What a scene is made of.
struct Parts {
  BoundsSource source;
  RTCOccludedFunctionN occluded;
  RTCPointQueryFunction near;
};

// Returns the first error that Embree, as a C library, kept to itself. May throw std::bad_alloc all
// the same: where there is no memory to keep the error in.
RTCError make_scene(RTCDevice device, const Parts& parts, EmbreeScene& out) {
  // The thread's error has its place from the first look at it on, which may itself fail and leave
  // an error behind.
  if (rtcGetDeviceError(device) && rtcGetDeviceError(device)) return RTC_ERROR_OUT_OF_MEMORY;
  const EmbreeGeometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER));
  if (!geometry) return rtcGetDeviceError(device);
  rtcSetGeometryUserPrimitiveCount(geometry.get(),
                                   static_cast<unsigned>(parts.source.boxes.size()));
  BoundsSource source = parts.source;
  rtcSetGeometryUserData(geometry.get(), &source);
  rtcSetGeometryBoundsFunction(geometry.get(), write_bounds, nullptr);
  rtcSetGeometryOccludedFunction(geometry.get(), parts.occluded);
  rtcSetGeometryPointQueryFunction(geometry.get(), parts.near);
  rtcCommitGeometry(geometry.get());
  out.reset(rtcNewScene(device));
  if (!out) return rtcGetDeviceError(device);
  rtcSetSceneFlags(out.get(), RTC_SCENE_FLAG_ROBUST);
  rtcAttachGeometry(out.get(), geometry.get());
  rtcCommitScene(out.get());
  rtcSetGeometryUserData(geometry.get(), nullptr);  // the source ends here
  return rtcGetDeviceError(device);
}

// The same on a thread that ends with it.
RTCError make_scene_apart(RTCDevice device, const Parts& parts, EmbreeScene& out) {
  RTCError error = RTC_ERROR_OUT_OF_MEMORY;
  try {
    std::thread([&]() noexcept {
      try {
        error = make_scene(device, parts, out);
      } catch (const std::bad_alloc&) {
      }
    }).join();
  } catch (const std::system_error&) {  // no room for a thread
  }
  return error;
}

// A scene whose build failed is kept to the end of the process: releasing it ends the process where
// tasks of the build were left behind.
struct HalfBuilt {
  EmbreeScene scene;
  HalfBuilt* next = nullptr;
};

void keep(std::unique_ptr<HalfBuilt> scene) noexcept {
  static std::atomic<HalfBuilt*> all = nullptr;
  HalfBuilt* const node = scene.release();
  node->next = all.load();
  while (!all.compare_exchange_weak(node->next, node)) {
  }
}

// Where memory runs out inside a build, what Embree keeps of its thread may refer to memory that is
// gone, and the thread's next build would write there. So from the first failure in a process on,
// each build has a thread of its own.
EmbreeScene made_scene(RTCDevice device, const Parts& parts) {
  static std::atomic<bool> any_failed = false;
  auto out = std::make_unique<HalfBuilt>();  // while there is memory
  EmbreeScene& scene = out->scene;
  RTCError error = RTC_ERROR_OUT_OF_MEMORY;
  try {
    error = (any_failed ? make_scene_apart : make_scene)(device, parts, scene);
  } catch (const std::bad_alloc&) {
  }
  if (error == RTC_ERROR_NONE && scene) return std::move(scene);
  any_failed = true;
  keep(std::move(out));
  throw_error(error);
}

struct Started {
  RTCDevice device = nullptr;
  RTCError error = RTC_ERROR_OUT_OF_MEMORY;
};

Started start() noexcept {
  Started out;
  try {
    out.device = rtcNewDevice("threads=1");
    if (!out.device) out.error = rtcGetDeviceError(nullptr);
  } catch (const std::bad_alloc&) {  // not even the error could be kept
  }
  return out;
}

}  // namespace

RTCDevice embree_device() {
  static const Started embree = start();
  if (!embree.device) throw_error(embree.error);
  return embree.device;
}

EmbreeBoxes build(std::span<const Aabb> boxes, RTCOccludedFunctionN occluded,
                  RTCPointQueryFunction near) {
  EmbreeBoxes out;
  const Aabb all = *bounds(boxes);
  const double size = (all.max - all.min).maxCoeff();
  out.corner = all.min;
  out.extent = all;
  // Queries are clipped to `reach` where they leave it. Rounding origin and direction to float
  // moves a point by less than 2^-22 of the reach, and the subtraction of the corner by an ulp.
  const double largest = std::max(all.min.cwiseAbs().maxCoeff(), all.max.cwiseAbs().maxCoeff());
  out.pad = std::max({4e-4, std::ldexp(size, -20), std::ldexp(largest, -48)});
  const Vec3 margin = Vec3::Constant(1000);
  out.reach = {all.min - margin, all.max + margin};
  out.scene = made_scene(embree_device(), {{boxes, out.corner, out.pad}, occluded, near});
  return out;
}

bool occluded(const EmbreeBoxes& boxes, const Vec3& a, const Vec3& b,
              RTCIntersectContext& context) {
  Vec3 from = a;
  Vec3 to = b;
  const bool inside = contains(boxes.reach, a) && contains(boxes.reach, b);
  if (!inside) {
    const auto reached = clip(a, b, boxes.reach);
    if (!reached) return false;
    from = a + (b - a) * reached->from;
    to = a + (b - a) * reached->to;
  }
  RTCRay ray{};
  ray.org_x = static_cast<float>(from[0] - boxes.corner[0]);
  ray.org_y = static_cast<float>(from[1] - boxes.corner[1]);
  ray.org_z = static_cast<float>(from[2] - boxes.corner[2]);
  ray.dir_x = static_cast<float>(to[0] - from[0]);
  ray.dir_y = static_cast<float>(to[1] - from[1]);
  ray.dir_z = static_cast<float>(to[2] - from[2]);
  ray.tfar = 1;
  ray.mask = ~0u;
  rtcOccluded1(boxes.scene.get(), &context, &ray);
  return ray.tfar < 0;
}

double slack_at(const EmbreeBoxes& boxes, const Vec3& p) {
  // Far outside, single precision is coarser than the pad: widen by what it may lose there.
  return boxes.pad + std::ldexp((p - boxes.corner).cwiseAbs().maxCoeff(), -22);
}

void near(const EmbreeBoxes& boxes, const Vec3& p, double radius, void* context) {
  RTCPointQueryContext rtc;
  rtcInitPointQueryContext(&rtc);
  const Vec3 local = p - boxes.corner;
  RTCPointQuery query{static_cast<float>(local[0]), static_cast<float>(local[1]),
                      static_cast<float>(local[2]), 0.0f, float_up(radius)};
  rtcPointQuery(boxes.scene.get(), &query, &rtc, nullptr, context);
}

void mark_hit(const RTCOccludedFunctionNArguments* args) noexcept {
  RTCRayN_tfar(args->ray, args->N, 0) = -std::numeric_limits<float>::infinity();
}

}  // namespace geom
