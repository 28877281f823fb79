#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <deque>
#include <limits>
#include <map>
#include <mutex>
#include <new>
#include <stdexcept>
#include <utility>

#include "geom/collision.h"
#include "geom/mapped_file.h"
#include "nearest_hints.h"
#include "skyline.h"

// Two levels of Embree scenes: one over groups of neighbouring tiles, and one a group over its
// boxes, built on first touch and given up, the oldest first, past the budget. A small map is one
// group and has no upper level. Embree only proposes candidates, in single precision relative to a
// near corner and with bounds padded past every rounding; each candidate is decided in double.

namespace geom {
namespace {

constexpr float kFloatInfinity = std::numeric_limits<float>::infinity();
constexpr std::size_t kEmbreeBytesPerBox = 80;  // measured: 78

float float_up(double x) {
  const float f = static_cast<float>(x);
  return f < x ? std::nextafter(f, kFloatInfinity) : f;
}
float float_down(double x) { return -float_up(-x); }

struct Handles {  // an Embree scene over closed boxes, its coordinates relative to `corner`
  RTCScene scene = nullptr;
  Vec3 corner = Vec3::Zero();
  Aabb extent;     // the bounding box of the boxes
  Aabb reach;      // that, plus what queries may stick out
  double pad = 0;  // what the bounds given to Embree exceed the boxes by, in metres

  Handles() = default;
  Handles(const Handles&) = delete;
  Handles& operator=(const Handles&) = delete;
  ~Handles() {
    if (scene) rtcReleaseScene(scene);
  }
};

struct GroupScene {
  Handles handles;
  std::vector<std::size_t> box;  // ascending: their indices in the map
  std::vector<Aabb> grown;
  std::vector<Aabb> by_vehicle;  // grown without the margin; empty where that is the same
  Skyline skyline;
  NearestHints hints;

  // For the next search, where the box is of this group.
  void remember(std::size_t map_box, std::atomic<std::uint32_t>& hint) const {
    const auto at = std::lower_bound(box.begin(), box.end(), map_box);
    if (at == box.end() || *at != map_box) return;
    hint.store(static_cast<std::uint32_t>(at - box.begin()), std::memory_order_relaxed);
  }

  const Aabb& without_margin(std::size_t i) const {
    return by_vehicle.empty() ? grown[i] : by_vehicle[i];
  }
  std::size_t bytes() const {
    return box.size() * (sizeof(std::size_t) + kEmbreeBytesPerBox) +
           (grown.size() + by_vehicle.size()) * sizeof(Aabb) + hints.bytes() + (1 << 15);
  }
};

// Tiles whose boxes share a scene.
struct Group {
  std::vector<std::size_t> tiles;
  Aabb extent;                                    // grown
  std::atomic<const GroupScene*> scene{nullptr};  // null until touched, and again once given up
  std::atomic<int> users{0};                      // queries inside; never given up while > 0
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
  out.extent = all;
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

// The tiles by squares of so many tiles that a square has about `wanted` boxes; the tile of large
// boxes is a group of its own unless the whole map is one group.
std::vector<std::vector<std::size_t>> grouped(const BoxMap& map, double wanted) {
  const auto tiles = map.tiles();
  if (tiles.empty()) return {};
  const double per_tile = static_cast<double>(map.size()) / static_cast<double>(tiles.size());
  const bool one = static_cast<double>(map.size()) <= 2 * wanted;
  const auto side = static_cast<std::int32_t>(std::ceil(std::sqrt(wanted / per_tile)));
  const auto square = [&](std::int32_t i) {
    return one ? 0 : i >= 0 ? i / side : -1 - (-1 - i) / side;
  };
  std::map<std::tuple<bool, std::int32_t, std::int32_t>, std::vector<std::size_t>> groups;
  for (std::size_t t = 0; t < tiles.size(); ++t) {
    groups[{!one && tiles[t].large, square(tiles[t].iy), square(tiles[t].ix)}].push_back(t);
  }
  std::vector<std::vector<std::size_t>> out;
  for (auto& [key, members] : groups) out.push_back(std::move(members));
  return out;
}

}  // namespace

struct CollisionScene::Impl {
  BoxMap map;
  Vehicle vehicle;
  double margin;
  Vec3 half;
  std::size_t budget;
  std::optional<Aabb> free_bounds;
  RTCDevice device = nullptr;
  Handles top;
  std::vector<Aabb> group_extent;
  std::vector<Group> groups;
  std::mutex building;            // guards the two below and every change of Group::scene
  std::deque<std::size_t> built;  // groups with a scene, oldest first
  std::size_t bytes = 0;          // of all scenes

  Impl(BoxMap m, Vehicle v, double mg, const CollisionOptions& options);
  ~Impl() {
    for (Group& group : groups) delete group.scene.load();
    if (top.scene) rtcReleaseScene(std::exchange(top.scene, nullptr));
    rtcReleaseDevice(device);
  }

  // The group's scene, built if need be. It stays while the caller counts among `users`.
  const GroupScene& touch(std::size_t g) {
    const GroupScene* scene = groups[g].scene.load();
    return scene ? *scene : build_group(g);
  }
  const GroupScene& build_group(std::size_t g);
  void give_up_oldest(std::size_t keep);
};

namespace {

// A query inside a group.
class Visit {
 public:
  Visit(CollisionScene::Impl& impl, std::size_t g) : group_(impl.groups[g]) {
    group_.users.fetch_add(1);
    scene_ = &impl.touch(g);
  }
  ~Visit() { group_.users.fetch_sub(1); }
  Visit(const Visit&) = delete;
  Visit& operator=(const Visit&) = delete;

  const GroupScene& scene() const { return *scene_; }

 private:
  Group& group_;
  const GroupScene* scene_;
};

struct SegmentContext {
  RTCIntersectContext rtc;
  CollisionScene::Impl* impl;
  const Vec3* a;
  const Vec3* b;
  const GroupScene* group;
};

void mark_hit(const RTCOccludedFunctionNArguments* args) {
  RTCRayN_tfar(args->ray, args->N, 0) = -kFloatInfinity;
}

void segment_against_box(const RTCOccludedFunctionNArguments* args) {
  if (!args->valid[0]) return;
  const auto& context = *reinterpret_cast<const SegmentContext*>(args->context);
  if (segment_hits(*context.a, *context.b, context.group->grown[args->primID])) mark_hit(args);
}

bool hits_group(const SegmentContext& outer, const GroupScene& group) {
  if (group.skyline.clears(*outer.a, *outer.b)) return false;
  SegmentContext inner = outer;
  rtcInitIntersectContext(&inner.rtc);
  inner.group = &group;
  return occluded(group.handles, *outer.a, *outer.b, inner);
}

void segment_against_group(const RTCOccludedFunctionNArguments* args) {
  if (!args->valid[0]) return;
  const auto& outer = *reinterpret_cast<const SegmentContext*>(args->context);
  if (!segment_hits(*outer.a, *outer.b, outer.impl->group_extent[args->primID])) return;
  const Visit visit(*outer.impl, args->primID);
  if (hits_group(outer, visit.scene())) mark_hit(args);
}

struct NearestContext {
  CollisionScene::Impl* impl;
  Vec3 point;
  std::span<Nearest> room;  // for as many as are wanted
  std::size_t found = 0;    // a heap at the start of `room`, the worst on top
  double radius;            // boxes further than this are of no interest
  const GroupScene* group = nullptr;
};

struct RegionContext {
  CollisionScene::Impl* impl;
  const Aabb* region;
  Vec3 center;
  double radius;
  std::size_t most;                // more are not wanted,
  std::vector<std::size_t> found;  // and the search ends with one more
  const GroupScene* group = nullptr;

  bool too_many() const { return found.size() > most; }
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

CollisionScene::Impl::Impl(BoxMap m, Vehicle v, double mg, const CollisionOptions& options)
    : map(std::move(m)), vehicle(std::move(v)), margin(mg), budget(options.budget) {
  for (int i = 0; i < 3; ++i) {
    half[i] = vehicle.half[i] + margin;
    if (margin > 0) half[i] = std::nextafter(half[i], std::numeric_limits<double>::infinity());
  }
  free_bounds = shrink(map.spec().bounds, half);
  device = rtcNewDevice("threads=1");
  if (!device) throw_on_error(nullptr);
  auto members = grouped(map, static_cast<double>(options.boxes_per_group));
  groups = std::vector<Group>(members.size());
  for (std::size_t g = 0; g < groups.size(); ++g) {
    groups[g].tiles = std::move(members[g]);
    Aabb extent = map.tiles()[groups[g].tiles.front()].extent;
    for (const std::size_t t : groups[g].tiles) extent = merged(extent, map.tiles()[t].extent);
    group_extent.push_back(grow(extent, half));
  }
  if (groups.size() > 1) build(device, group_extent, segment_against_group, visit, nullptr, top);
}

const GroupScene& CollisionScene::Impl::build_group(std::size_t g) {
  const std::lock_guard lock(building);
  if (const GroupScene* scene = groups[g].scene.load()) return *scene;
  auto scene = std::make_unique<GroupScene>();
  std::size_t count = 0;
  for (const std::size_t t : groups[g].tiles) count += map.tiles()[t].count;
  scene->box.reserve(count);
  scene->grown.reserve(count);
  if (margin > 0) scene->by_vehicle.reserve(count);
  for (const std::size_t t : groups[g].tiles) {
    std::size_t i = map.tiles()[t].first;
    for (const Aabb& box : map.boxes_of(t)) {
      scene->box.push_back(i++);
      scene->grown.push_back(grow(box, half));
      if (margin > 0) scene->by_vehicle.push_back(grow(box, vehicle.half));
    }
  }
  geom::build(device, scene->grown, segment_against_box, visit, nullptr, scene->handles);
  scene->skyline = Skyline(scene->grown, scene->handles.extent);
  scene->hints = NearestHints(scene->handles.extent, scene->grown.size());
  bytes += scene->bytes();
  built.push_back(g);
  groups[g].scene.store(scene.get());
  const GroupScene& made = *scene.release();
  if (bytes > budget) give_up_oldest(g);
  trim_mapped_files();
  return made;
}

// A query counts itself among the users before it reads `scene`, and here `scene` is taken away
// before the users are counted, so one of the two always sees the other.
void CollisionScene::Impl::give_up_oldest(std::size_t keep) {
  for (std::size_t tries = built.size(); tries > 0 && bytes > budget; --tries) {
    const std::size_t g = built.front();
    built.pop_front();
    const GroupScene* scene = groups[g].scene.exchange(nullptr);
    if (g == keep || groups[g].users.load() > 0) {
      groups[g].scene.store(scene);
      built.push_back(g);
      continue;
    }
    bytes -= scene->bytes();
    delete scene;
  }
}

namespace {

bool closer(const Nearest& a, const Nearest& b) {
  return std::tie(a.distance, a.box) < std::tie(b.distance, b.box);
}

void visit_nearest_box(NearestContext& context, std::size_t i) {
  const Nearest next{context.group->box[i],
                     distance(context.point, context.group->without_margin(i))};
  if (next.distance > context.radius) return;
  const auto begin = context.room.begin();
  if (context.found == context.room.size()) {
    if (!closer(next, context.room.front())) return;
    std::pop_heap(begin, begin + static_cast<std::ptrdiff_t>(context.found), closer);
    context.room.back() = next;
  } else {
    context.room[context.found++] = next;
  }
  std::push_heap(begin, begin + static_cast<std::ptrdiff_t>(context.found), closer);
  if (context.found == context.room.size()) context.radius = context.room.front().distance;
}

void search_group(NearestContext& context, const GroupScene& group);
void search_group(RegionContext& context, const GroupScene& group);

bool visit_nearest(RTCPointQueryFunctionArguments* args, NearestContext& context, bool top,
                   double slack) {
  const double before = context.radius;
  if (!top) {
    visit_nearest_box(context, args->primID);
  } else {
    if (distance(context.point, context.impl->group_extent[args->primID]) > context.radius) {
      return false;
    }
    const Visit visit(*context.impl, args->primID);
    search_group(context, visit.scene());
  }
  if (context.radius == before) return false;
  args->query->radius = float_up(context.radius + slack);
  return true;
}

bool visit_region(RTCPointQueryFunctionArguments* args, RegionContext& context, bool top) {
  if (context.too_many()) return false;
  if (!top) {
    if (overlap(*context.region, context.group->grown[args->primID])) {
      context.found.push_back(context.group->box[args->primID]);
    }
  } else if (overlap(*context.region, context.impl->group_extent[args->primID])) {
    const Visit visit(*context.impl, args->primID);
    search_group(context, visit.scene());
  }
  if (!context.too_many()) return false;
  args->query->radius = 0;  // leaves little to visit
  return true;
}

bool visit(RTCPointQueryFunctionArguments* args) {
  auto& context = *static_cast<PointContext*>(args->userPtr);
  if (context.nearest) return visit_nearest(args, *context.nearest, context.top, context.slack);
  return visit_region(args, *context.region, context.top);
}

void search_group(NearestContext& context, const GroupScene& group) {
  context.group = &group;
  PointContext inner{&context, nullptr, false};
  if (context.room.size() > 1) {
    near(group.handles, context.point, context.radius, inner);
    return;
  }
  // A search for one starts from a box that is likely near.
  std::atomic<std::uint32_t>& hint = group.hints.at(context.point);
  const std::uint32_t known = hint.load(std::memory_order_relaxed);
  if (known != NearestHints::kNone) {
    const double hinted = distance(context.point, group.without_margin(known));
    context.radius = std::min(context.radius, hinted);
  }
  near(group.handles, context.point, context.radius, inner);
  if (known == NearestHints::kNone && context.found == 1) group.remember(context.room[0].box, hint);
}

void search_group(RegionContext& context, const GroupScene& group) {
  context.group = &group;
  PointContext inner{nullptr, &context, false};
  near(group.handles, context.center, context.radius, inner);
}

}  // namespace

CollisionScene::CollisionScene(BoxMap map, Vehicle vehicle, double margin,
                               const CollisionOptions& options)
    : impl_(std::make_unique<Impl>(std::move(map), std::move(vehicle), margin, options)) {}
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
  if (impl_->groups.empty()) return false;
  SegmentContext context{{}, impl_.get(), &a, &b, nullptr};
  // The only group is never given up.
  if (impl_->groups.size() == 1) return hits_group(context, impl_->touch(0));
  rtcInitIntersectContext(&context.rtc);
  return occluded(impl_->top, a, b, context);
}

bool CollisionScene::free(const Vec3& a, const Vec3& b) const {
  return inside_bounds(a) && inside_bounds(b) && !hits(a, b);
}

std::size_t CollisionScene::nearest(const Vec3& p, double radius, std::span<Nearest> room) const {
  if (impl_->groups.empty() || room.empty()) return 0;
  NearestContext context{impl_.get(), p, room, 0, radius};
  if (impl_->groups.size() == 1) {
    search_group(context, impl_->touch(0));
  } else {
    PointContext point{&context, nullptr, true};
    near(impl_->top, p, radius, point);
  }
  std::sort_heap(room.begin(), room.begin() + static_cast<std::ptrdiff_t>(context.found), closer);
  return context.found;
}

std::optional<Nearest> CollisionScene::nearest(const Vec3& p, double radius) const {
  Nearest one;
  if (nearest(p, radius, std::span(&one, 1)) == 0) return std::nullopt;
  return one;
}

std::vector<Nearest> CollisionScene::nearest(const Vec3& p, double radius,
                                             std::size_t count) const {
  std::vector<Nearest> list(std::min(count, impl_->map.size()));
  list.resize(nearest(p, radius, std::span(list)));
  return list;
}

std::optional<std::vector<std::size_t>> CollisionScene::boxes_meeting(const Aabb& region,
                                                                      std::size_t most) const {
  if (impl_->groups.empty()) return std::vector<std::size_t>();
  const Vec3 center = 0.5 * (region.min + region.max);
  const double radius = 0.5 * (region.max - region.min).norm() * (1 + 1e-12) + 1e-9;
  RegionContext context{impl_.get(), &region, center, radius, most, {}};
  if (impl_->groups.size() == 1) {
    search_group(context, impl_->touch(0));
  } else {
    PointContext point{nullptr, &context, true};
    near(impl_->top, center, radius, point);
  }
  if (context.too_many()) return std::nullopt;
  std::sort(context.found.begin(), context.found.end());
  return std::move(context.found);
}

std::vector<std::size_t> CollisionScene::boxes_meeting(const Aabb& region) const {
  return *boxes_meeting(region, impl_->map.size());
}

Aabb CollisionScene::grown(std::size_t i) const { return grow(impl_->map.box(i), impl_->half); }

}  // namespace geom
