#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <new>
#include <stdexcept>

#include "embree_library.h"
#include "geom/picture/picture_scene.h"
#include "ray_lanes.h"

namespace geom::picture {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();
constexpr float kNear = 1e-3f;  // metres in front of the eye

// Corners of a face (bit i of a corner: its upper side on axis i), counter-clockwise from outside.
constexpr std::uint32_t kFaces[6][4] = {{0, 4, 6, 2}, {0, 1, 5, 4}, {0, 2, 3, 1},
                                        {1, 3, 7, 5}, {2, 6, 7, 3}, {4, 5, 7, 6}};

struct Corner {
  float x, y, z;
};

void throw_on_error(RTCDevice device) {
  const RTCError error = embree().device_error(device);
  if (error == RTC_ERROR_NONE) return;
  if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  throw std::runtime_error("Embree could not build the scene of the picture");
}

// The library that was loaded may have another version than the headers.
void require_version(RTCDevice device) {
  const auto version = embree().device_property(device, RTC_DEVICE_PROPERTY_VERSION);
  if (version / 10000 == RTC_VERSION_MAJOR && version / 100 >= RTC_VERSION / 100) return;
  throw std::runtime_error(
      fmt::format("Embree is of version {}.{}, expected {}.{} or a later one of {}: install the "
                  "package libembree3-3",
                  version / 10000, version / 100 % 100, RTC_VERSION_MAJOR, RTC_VERSION_MINOR,
                  RTC_VERSION_MAJOR));
}

}  // namespace

struct PictureScene::Embree {
  // One thread builds, so that the tree, and with it the order of equal depths, is always the same.
  const EmbreeLibrary& rtc = embree();
  RTCDevice device = rtc.new_device("threads=1");
  RTCScene scene = device ? rtc.new_scene(device) : nullptr;

  // Never released where this throws: a process whose memory ran out while Embree started ends.
  Embree() {
    if (!scene) {
      throw_on_error(device);
      throw std::runtime_error("Embree does not start on this processor");
    }
    require_version(device);
    rtc.set_scene_flags(scene, RTC_SCENE_FLAG_ROBUST);
  }
  ~Embree() {
    rtc.release_scene(scene);
    rtc.release_device(device);
  }

  RTCGeometry new_geometry(RTCGeometryType type) {
    RTCGeometry geometry = rtc.new_geometry(device, type);
    if (!geometry) throw std::bad_alloc();
    return geometry;
  }

  template <class T>
  T* buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::size_t count) {
    void* memory = rtc.set_new_geometry_buffer(geometry, type, 0, format, sizeof(T), count);
    if (!memory) throw std::bad_alloc();
    return static_cast<T*>(memory);
  }

  void attach(RTCGeometry geometry, unsigned id) {
    rtc.commit_geometry(geometry);
    rtc.attach_geometry(scene, geometry, id);
    rtc.release_geometry(geometry);
    throw_on_error(device);
  }

  void add_boxes(std::span<const Aabb> boxes, const Vec3& middle, const std::vector<bool>& unseen) {
    RTCGeometry geometry = new_geometry(RTC_GEOMETRY_TYPE_QUAD);
    auto* corner =
        buffer<Corner>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, 8 * boxes.size());
    auto* face = buffer<std::array<std::uint32_t, 4>>(geometry, RTC_BUFFER_TYPE_INDEX,
                                                      RTC_FORMAT_UINT4, 6 * boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const Eigen::Vector3f low = (boxes[i].min - middle).cast<float>();
      const bool seen = unseen.empty() || !unseen[i];
      const Eigen::Vector3f high =
          seen ? Eigen::Vector3f((boxes[i].max - middle).cast<float>()) : low;
      for (int k = 0; k < 8; ++k) {
        *corner++ = {k & 1 ? high.x() : low.x(), k & 2 ? high.y() : low.y(),
                     k & 4 ? high.z() : low.z()};
      }
      const auto first = static_cast<std::uint32_t>(8 * i);
      for (const auto& f : kFaces) {
        *face++ = {first + f[0], first + f[1], first + f[2], first + f[3]};
      }
    }
    attach(geometry, 0);
  }

  void add_tubes(const Tubes& tubes, const Vec3& middle, unsigned id) {
    RTCGeometry geometry = new_geometry(RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE);
    auto* point = buffer<Eigen::Vector4f>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4,
                                          2 * tubes.edges.size());
    auto* index =
        buffer<std::uint32_t>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT, tubes.edges.size());
    std::uint32_t next = 0;
    for (const auto& [a, b] : tubes.edges) {
      *index++ = next;
      next += 2;
      for (const std::uint32_t end : {a, b}) {
        const Eigen::Vector3f p = (tubes.points[end] - middle).cast<float>();
        *point++ = {p.x(), p.y(), p.z(), static_cast<float>(tubes.radius)};
      }
    }
    attach(geometry, id);
  }
};

PictureScene::PictureScene(const BoxMap& map, std::span<const Tubes> tubes,
                           const std::vector<bool>& unseen)
    : embree_(std::make_unique<Embree>()) {
  const Axes axes = map.spec().frame.axes;
  const Aabb bounds = to_enu(axes, map.spec().bounds);
  ground_ = bounds.min.z();
  middle_ = 0.5 * (bounds.min + bounds.max);
  for (const Aabb& box : map.boxes()) boxes_.push_back(to_enu(axes, box));
  if (boxes_.size() > 0xffffffffu / 8) {
    throw std::runtime_error("a picture shows at most 536870911 boxes: crop the map");
  }
  if (!boxes_.empty()) embree_->add_boxes(boxes_, middle_, unseen);
  for (const Tubes& t : tubes) {
    tube_colours_.push_back(t.colour);
    if (!t.edges.empty()) {
      embree_->add_tubes(t, middle_, static_cast<unsigned>(tube_colours_.size()));
    }
  }
  embree_->rtc.commit_scene(embree_->scene);
  try {
    throw_on_error(embree_->device);
  } catch (...) {
    // Releasing what is half built would end the process where tasks were left behind.
    static_cast<void>(embree_.release());
    throw;
  }
}

PictureScene::~PictureScene() = default;

// Inline: of a call the hit comes back in pieces, and each pixel waits until it can be read whole.
inline Hit PictureScene::named(const Ray& ray, unsigned geometry, unsigned primitive,
                               float depth) const {
  Hit hit;
  double first = std::numeric_limits<double>::infinity();
  if (geometry == 0) {
    const int face = static_cast<int>(primitive % 6);
    const int axis = face % 3;
    const Aabb& box = boxes_[primitive / 6];
    const double plane = face < 3 ? box.min[axis] : box.max[axis];
    first = (plane - ray.origin[axis]) / ray.direction[axis];
    hit.kind = Hit::Kind::box;
    hit.face = static_cast<std::uint8_t>(face);
    hit.object = primitive / 6;
  } else if (geometry != RTC_INVALID_GEOMETRY_ID) {
    first = depth;
    hit.kind = Hit::Kind::tube;
    hit.object = geometry - 1;
  }
  // Whether the ray is below the ground where the surface is, without a division.
  const double fall = ground_ - ray.origin.z();
  if (ray.direction.z() < 0 && fall < kNear * ray.direction.z() &&
      first * ray.direction.z() < fall) {
    first = fall / ray.direction.z();
    hit.kind = Hit::Kind::ground;
  }
  hit.depth = hit.kind == Hit::Kind::sky ? 0 : static_cast<float>(first);
  return hit;
}

Block PictureScene::cast(const Rays& view, int x, int y) const {
  alignas(64) RTCRayHit16 packet;
  alignas(64) int valid[16];
  std::array<Ray, 16> rays;
  for (int i = 0; i < 16; ++i) {
    rays[i] = view.through(x + i % kBlock, y + i / kBlock);
    const Eigen::Vector3f origin = (rays[i].origin - middle_).cast<float>();
    const Eigen::Vector3f direction = rays[i].direction.cast<float>();
    packet.ray.org_x[i] = origin.x();
    packet.ray.org_y[i] = origin.y();
    packet.ray.org_z[i] = origin.z();
    packet.ray.dir_x[i] = direction.x();
    packet.ray.dir_y[i] = direction.y();
    packet.ray.dir_z[i] = direction.z();
    packet.ray.tnear[i] = kNear;
    packet.ray.tfar[i] = kFar;
    packet.ray.time[i] = 0;
    packet.ray.mask[i] = ~0u;
    packet.ray.id[i] = 0;
    packet.ray.flags[i] = 0;
    packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    valid[i] = -1;
  }
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  embree_->rtc.intersect16(valid, embree_->scene, &context, &packet);
  Block out;
  for (int i = 0; i < 16; ++i) {
    out[i] = named(rays[i], packet.hit.geomID[i], packet.hit.primID[i], packet.ray.tfar[i]);
    if (out[i].kind == Hit::Kind::tube) {
      out[i].normal =
          Eigen::Vector3f(packet.hit.Ng_x[i], packet.hit.Ng_y[i], packet.hit.Ng_z[i]).normalized();
    }
  }
  return out;
}

namespace {

constexpr int kRays = kBlock * kBlock;

#if defined(__x86_64__)
// A face has the number of its side in the list of all boxes' sides.
static_assert(sizeof(Aabb) == 6 * sizeof(double) && kBlock == 4 && kRays == 2 * RayLanes::kLanes);

struct Packet {
  alignas(64) RTCRayHit16 rtc;

  Packet() {
    std::fill_n(rtc.ray.tnear, kRays, kNear);
    std::fill_n(rtc.ray.tfar, kRays, kFar);
    std::fill_n(rtc.ray.time, kRays, 0.0f);
    std::fill_n(rtc.ray.mask, kRays, ~0u);
    std::fill_n(rtc.ray.id, kRays, 0u);
    std::fill_n(rtc.ray.flags, kRays, 0u);
    std::fill_n(rtc.hit.geomID, kRays, RTC_INVALID_GEOMETRY_ID);
  }

  SKYWAY_RAY_LANES void set(const RayLanes& rays, const Vec3& middle, int from) {
    float* const origins[] = {rtc.ray.org_x, rtc.ray.org_y, rtc.ray.org_z};
    float* const directions[] = {rtc.ray.dir_x, rtc.ray.dir_y, rtc.ray.dir_z};
#pragma GCC unroll 3
    for (int i = 0; i < 3; ++i) {
      RayLanes::store(_mm512_sub_pd(rays.origin[i], _mm512_set1_pd(middle[i])), origins[i] + from);
      RayLanes::store(rays.direction[i], directions[i] + from);
    }
  }

  MetByRays met(int from) const {
    return {rtc.hit.geomID + from, rtc.hit.primID + from, rtc.ray.tfar + from,
            RTC_INVALID_GEOMETRY_ID};
  }
};

struct DepthCast {
  decltype(&rtcIntersect16) intersect16;
  RTCScene scene;
  const Rays& rays;
  Vec3 middle;
  Surfaces surfaces;
};

SKYWAY_RAY_LANES std::array<float, kRays> cast_depths(const DepthCast& cast, int x, int y) {
  alignas(64) static constexpr int kAll[kRays] = {-1, -1, -1, -1, -1, -1, -1, -1,
                                                  -1, -1, -1, -1, -1, -1, -1, -1};
  const RayLanes first(cast.rays, x, y);
  const RayLanes second(cast.rays, x, y + 2);
  Packet packet;
  packet.set(first, cast.middle, 0);
  packet.set(second, cast.middle, RayLanes::kLanes);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  cast.intersect16(kAll, cast.scene, &context, &packet.rtc);
  std::array<float, kRays> out;
  write_depths(first, packet.met(0), cast.surfaces, out.data());
  write_depths(second, packet.met(RayLanes::kLanes), cast.surfaces, out.data() + RayLanes::kLanes);
  return out;
}
#endif

}  // namespace

std::array<float, kBlock * kBlock> PictureScene::depths(const Rays& rays, int x, int y) const {
#if defined(__x86_64__)
  if (RayLanes::usable()) {
    const double* const sides = boxes_.empty() ? nullptr : boxes_.front().min.data();
    return cast_depths(
        {embree_->rtc.intersect16, embree_->scene, rays, middle_, {sides, ground_, kNear}}, x, y);
  }
#endif
  std::array<float, kRays> out;
  const Block block = cast(rays, x, y);
  std::transform(block.begin(), block.end(), out.begin(), [](const Hit& hit) { return hit.depth; });
  return out;
}

float PictureScene::unhidden(const Vec3& from,
                             std::span<const Eigen::Vector3f, 16> directions) const {
  alignas(64) RTCRay16 packet;
  alignas(64) int valid[16];
  const Eigen::Vector3f origin = (from - middle_).cast<float>();
  for (int i = 0; i < 16; ++i) {
    packet.org_x[i] = origin.x();
    packet.org_y[i] = origin.y();
    packet.org_z[i] = origin.z();
    packet.dir_x[i] = directions[i].x();
    packet.dir_y[i] = directions[i].y();
    packet.dir_z[i] = directions[i].z();
    packet.tnear[i] = kNear;
    packet.tfar[i] = kFar;
    packet.time[i] = 0;
    packet.mask[i] = ~0u;
    packet.id[i] = 0;
    packet.flags[i] = 0;
    valid[i] = -1;
  }
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  embree_->rtc.occluded16(valid, embree_->scene, &context, &packet);
  int clear = 0;
  for (const float end : packet.tfar) clear += end > 0;
  return static_cast<float>(clear) / 16;
}

}  // namespace geom::picture
