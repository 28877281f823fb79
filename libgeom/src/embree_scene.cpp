#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <new>
#include <stdexcept>
#include <utility>

#include "geom/collision.h"

// Two levels of Embree scenes: one over the tiles, and one a tile over its boxes, built on first
// touch. Embree only proposes candidates, in single precision relative to a near corner and with
// bounds padded past every rounding; each candidate is decided in double.

namespace geom {
namespace {

constexpr float kFloatInfinity = std::numeric_limits<float>::infinity();

float float_up(double x) {
  const float f = static_cast<float>(x);
  return f < x ? std::nextafter(f, kFloatInfinity) : f;
}
float float_down(double x) { return -float_up(-x); }

struct Handles {  // an Embree scene over closed boxes, its coordinates relative to `corner`
  RTCScene scene = nullptr;
  Vec3 corner = Vec3::Zero();
  Aabb reach;      // the bounding box of the boxes, plus what queries may stick out
  double pad = 0;  // what the bounds given to Embree exceed the boxes by, in metres

  Handles() = default;
  Handles(const Handles&) = delete;
  Handles& operator=(const Handles&) = delete;
  ~Handles() {
    if (scene) rtcReleaseScene(scene);
  }
};

struct TileScene {
  Handles handles;
  std::vector<Aabb> grown;
  std::vector<Aabb> by_vehicle;  // grown without the margin; empty where that is the same
  std::once_flag built;

  const Aabb& without_margin(std::size_t i) const {
    return by_vehicle.empty() ? grown[i] : by_vehicle[i];
  }
};

void throw_on_error(RTCDevice device) {
  switch (rtcGetDeviceError(device)) {
    case RTC_ERROR_NONE:
      return;
    case RTC_ERROR_OUT_OF_MEMORY:
      throw std::bad_alloc();
    case RTC_ERROR_UNSUPPORTED_CPU:
      throw std::runtime_error("Embree does not support this processor");
    default:
      throw std::runtime_error("Embree could not build the collision structure");
  }
}

struct BoundsSource {  // what the bounds callback needs; lives on the stack during the build
  std::span<const Aabb> boxes;
  Vec3 corner;
  double pad;
};

void write_bounds(const RTCBoundsFunctionArguments* args) {
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

void build(RTCDevice device, std::span<const Aabb> boxes, RTCOccludedFunctionN occluded,
           RTCPointQueryFunction near, void* user, Handles& out) {
  Aabb all = boxes.front();
  for (const Aabb& box : boxes) all = merged(all, box);
  const double size = (all.max - all.min).maxCoeff();
  out.corner = all.min;
  // Queries are clipped to `reach` where they leave it. Rounding origin and direction to float
  // moves a point by less than 2^-22 of the reach, and the subtraction of the corner by an ulp.
  const double largest = std::max(all.min.cwiseAbs().maxCoeff(), all.max.cwiseAbs().maxCoeff());
  out.pad = std::max({4e-4, std::ldexp(size, -20), std::ldexp(largest, -48)});
  const Vec3 margin = Vec3::Constant(1000);
  out.reach = {all.min - margin, all.max + margin};

  BoundsSource source{boxes, out.corner, out.pad};
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(boxes.size()));
  rtcSetGeometryUserData(geometry, &source);
  rtcSetGeometryBoundsFunction(geometry, write_bounds, nullptr);
  rtcSetGeometryOccludedFunction(geometry, occluded);
  rtcSetGeometryPointQueryFunction(geometry, near);
  rtcCommitGeometry(geometry);
  out.scene = rtcNewScene(device);
  rtcSetSceneFlags(out.scene, RTC_SCENE_FLAG_ROBUST);
  rtcAttachGeometry(out.scene, geometry);
  rtcCommitScene(out.scene);
  rtcSetGeometryUserData(geometry, user);
  rtcReleaseGeometry(geometry);
  throw_on_error(device);
}

// The part of the segment inside `box`, or false when there is none.
bool clip(const Vec3& a, const Vec3& b, const Aabb& box, Vec3& from, Vec3& to) {
  const Vec3 d = b - a;
  double t0 = 0;
  double t1 = 1;
  for (int i = 0; i < 3; ++i) {
    if (std::max(a[i], b[i]) < box.min[i] || std::min(a[i], b[i]) > box.max[i]) return false;
    if (d[i] == 0) continue;
    const double u = (box.min[i] - a[i]) / d[i];
    const double v = (box.max[i] - a[i]) / d[i];
    t0 = std::max(t0, std::min(u, v));
    t1 = std::min(t1, std::max(u, v));
  }
  if (t0 > t1) return false;
  from = a + d * t0;
  to = a + d * t1;
  return true;
}

template <class Context>
bool occluded(const Handles& h, const Vec3& a, const Vec3& b, Context& context) {
  Vec3 from = a;
  Vec3 to = b;
  const bool inside = contains(h.reach, a) && contains(h.reach, b);
  if (!inside && !clip(a, b, h.reach, from, to)) return false;
  RTCRay ray{};
  ray.org_x = static_cast<float>(from[0] - h.corner[0]);
  ray.org_y = static_cast<float>(from[1] - h.corner[1]);
  ray.org_z = static_cast<float>(from[2] - h.corner[2]);
  ray.dir_x = static_cast<float>(to[0] - from[0]);
  ray.dir_y = static_cast<float>(to[1] - from[1]);
  ray.dir_z = static_cast<float>(to[2] - from[2]);
  ray.tfar = 1;
  ray.mask = ~0u;
  rtcOccluded1(h.scene, &context.rtc, &ray);
  return ray.tfar < 0;
}

template <class Context>
void near(const Handles& h, const Vec3& p, double radius, Context& context) {
  RTCPointQueryContext rtc;
  rtcInitPointQueryContext(&rtc);
  // Far outside, single precision is coarser than the pad: widen by what it may lose there.
  const Vec3 local = p - h.corner;
  context.slack = h.pad + std::ldexp(local.cwiseAbs().maxCoeff(), -22);
  RTCPointQuery query{static_cast<float>(local[0]), static_cast<float>(local[1]),
                      static_cast<float>(local[2]), 0.0f, float_up(radius + context.slack)};
  rtcPointQuery(h.scene, &query, &rtc, nullptr, &context);
}

}  // namespace

struct CollisionScene::Impl {
  BoxMap map;
  Vehicle vehicle;
  double margin;
  Vec3 half;
  std::optional<Aabb> free_bounds;
  RTCDevice device = nullptr;
  Handles top;
  std::vector<Aabb> tile_extent;
  std::vector<TileScene> tiles;

  Impl(BoxMap m, Vehicle v, double mg);
  ~Impl() {
    tiles.clear();
    if (top.scene) rtcReleaseScene(std::exchange(top.scene, nullptr));
    rtcReleaseDevice(device);
  }

  TileScene& tile(std::size_t t);
};

namespace {

struct SegmentContext {
  RTCIntersectContext rtc;
  CollisionScene::Impl* scene;
  const Vec3* a;
  const Vec3* b;
  TileScene* tile;
};

void mark_hit(const RTCOccludedFunctionNArguments* args) {
  RTCRayN_tfar(args->ray, args->N, 0) = -kFloatInfinity;
}

void segment_against_box(const RTCOccludedFunctionNArguments* args) {
  if (!args->valid[0]) return;
  const auto& context = *reinterpret_cast<const SegmentContext*>(args->context);
  if (segment_hits(*context.a, *context.b, context.tile->grown[args->primID])) mark_hit(args);
}

void segment_against_tile(const RTCOccludedFunctionNArguments* args);

struct NearestContext {
  CollisionScene::Impl* scene;
  Vec3 point;
  std::optional<Nearest> best;
  double radius;  // boxes further than this are of no interest
  const TileScene* tile = nullptr;
  std::size_t first_box = 0;
};

struct RegionContext {
  CollisionScene::Impl* scene;
  const Aabb* region;
  Vec3 center;
  double radius;
  std::vector<std::size_t> found;
  const TileScene* tile = nullptr;
  std::size_t first_box = 0;
};

// One point-query callback serves both kinds of query and both levels.
struct PointContext {
  NearestContext* nearest = nullptr;
  RegionContext* region = nullptr;
  bool top = true;
  double slack = 0;  // what the ball in float exceeds the radius by, in metres
};

bool visit(RTCPointQueryFunctionArguments* args);

}  // namespace

CollisionScene::Impl::Impl(BoxMap m, Vehicle v, double mg)
    : map(std::move(m)), vehicle(std::move(v)), margin(mg), tiles(map.tiles().size()) {
  for (int i = 0; i < 3; ++i) {
    half[i] = vehicle.half[i] + margin;
    if (margin > 0) half[i] = std::nextafter(half[i], std::numeric_limits<double>::infinity());
  }
  free_bounds = shrink(map.spec().bounds, half);
  device = rtcNewDevice("threads=1");
  if (!device) throw_on_error(nullptr);
  if (tiles.empty()) return;
  for (const Tile& t : map.tiles()) tile_extent.push_back(grow(t.extent, half));
  build(device, tile_extent, segment_against_tile, visit, nullptr, top);
}

TileScene& CollisionScene::Impl::tile(std::size_t t) {
  TileScene& scene = tiles[t];
  std::call_once(scene.built, [&] {
    const Tile& tile = map.tiles()[t];
    scene.grown.reserve(tile.count);
    for (const Aabb& box : map.boxes().subspan(tile.first, tile.count)) {
      scene.grown.push_back(grow(box, half));
      if (margin > 0) scene.by_vehicle.push_back(grow(box, vehicle.half));
    }
    build(device, scene.grown, segment_against_box, visit, nullptr, scene.handles);
  });
  return scene;
}

namespace {

void segment_against_tile(const RTCOccludedFunctionNArguments* args) {
  if (!args->valid[0]) return;
  const auto& outer = *reinterpret_cast<const SegmentContext*>(args->context);
  if (!segment_hits(*outer.a, *outer.b, outer.scene->tile_extent[args->primID])) return;
  SegmentContext inner = outer;
  rtcInitIntersectContext(&inner.rtc);
  inner.tile = &outer.scene->tile(args->primID);
  if (occluded(inner.tile->handles, *outer.a, *outer.b, inner)) mark_hit(args);
}

void visit_nearest_box(NearestContext& context, std::size_t i) {
  const double d = distance(context.point, context.tile->without_margin(i));
  const std::size_t box = context.first_box + i;
  if (d > context.radius) return;
  if (context.best && d == context.radius && box > context.best->box) return;
  context.best = Nearest{box, d};
  context.radius = d;
}

bool visit_nearest(RTCPointQueryFunctionArguments* args, NearestContext& context, bool top,
                   double slack) {
  CollisionScene::Impl& scene = *context.scene;
  const double before = context.radius;
  if (!top) {
    visit_nearest_box(context, args->primID);
  } else {
    if (distance(context.point, scene.tile_extent[args->primID]) > context.radius) return false;
    context.first_box = scene.map.tiles()[args->primID].first;
    context.tile = &scene.tile(args->primID);
    PointContext inner{&context, nullptr, false};
    near(context.tile->handles, context.point, context.radius, inner);
  }
  if (context.radius == before) return false;
  args->query->radius = float_up(context.radius + slack);
  return true;
}

void visit_region(RTCPointQueryFunctionArguments* args, RegionContext& context, bool top) {
  CollisionScene::Impl& scene = *context.scene;
  if (!top) {
    if (overlap(*context.region, context.tile->grown[args->primID])) {
      context.found.push_back(context.first_box + args->primID);
    }
    return;
  }
  if (!overlap(*context.region, scene.tile_extent[args->primID])) return;
  context.first_box = scene.map.tiles()[args->primID].first;
  context.tile = &scene.tile(args->primID);
  PointContext inner{nullptr, &context, false};
  near(context.tile->handles, context.center, context.radius, inner);
}

bool visit(RTCPointQueryFunctionArguments* args) {
  auto& context = *static_cast<PointContext*>(args->userPtr);
  if (context.nearest) return visit_nearest(args, *context.nearest, context.top, context.slack);
  visit_region(args, *context.region, context.top);
  return false;
}

}  // namespace

CollisionScene::CollisionScene(BoxMap map, Vehicle vehicle, double margin)
    : impl_(std::make_unique<Impl>(std::move(map), std::move(vehicle), margin)) {}
CollisionScene::~CollisionScene() = default;
CollisionScene::CollisionScene(CollisionScene&&) noexcept = default;
CollisionScene& CollisionScene::operator=(CollisionScene&&) noexcept = default;

const BoxMap& CollisionScene::map() const { return impl_->map; }
const Vehicle& CollisionScene::vehicle() const { return impl_->vehicle; }
double CollisionScene::margin() const { return impl_->margin; }
Vec3 CollisionScene::half() const { return impl_->half; }
const std::optional<Aabb>& CollisionScene::free_bounds() const { return impl_->free_bounds; }

bool CollisionScene::inside_bounds(const Vec3& p) const {
  return impl_->free_bounds && contains(*impl_->free_bounds, p);
}

bool CollisionScene::hits(const Vec3& a, const Vec3& b) const {
  if (impl_->tiles.empty()) return false;
  SegmentContext context{{}, impl_.get(), &a, &b, nullptr};
  rtcInitIntersectContext(&context.rtc);
  return occluded(impl_->top, a, b, context);
}

bool CollisionScene::free(const Vec3& a, const Vec3& b) const {
  return inside_bounds(a) && inside_bounds(b) && !hits(a, b);
}

std::optional<Nearest> CollisionScene::nearest(const Vec3& p, double radius) const {
  if (impl_->tiles.empty()) return std::nullopt;
  NearestContext context{impl_.get(), p, std::nullopt, radius};
  PointContext point{&context, nullptr, true};
  near(impl_->top, p, radius, point);
  return context.best;
}

std::vector<std::size_t> CollisionScene::boxes_meeting(const Aabb& region) const {
  if (impl_->tiles.empty()) return {};
  const Vec3 center = 0.5 * (region.min + region.max);
  const double radius = 0.5 * (region.max - region.min).norm() * (1 + 1e-12) + 1e-9;
  RegionContext context{impl_.get(), &region, center, radius, {}};
  PointContext point{nullptr, &context, true};
  near(impl_->top, center, radius, point);
  std::sort(context.found.begin(), context.found.end());
  return std::move(context.found);
}

Aabb CollisionScene::grown(std::size_t i) const { return grow(impl_->map.boxes()[i], impl_->half); }

}  // namespace geom
