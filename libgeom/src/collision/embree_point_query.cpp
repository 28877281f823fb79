#include <algorithm>
#include <atomic>

#include "embree_queries.h"
#include "geom/base/rounding.h"

namespace geom {
namespace {

struct NearestContext {
  CollisionScene::Impl* impl;
  Vec3 point;
  std::span<Nearest> room;  // for as many as are wanted
  double radius;            // boxes further than this are of no interest
  Failure* failure;
  std::size_t found = 0;  // a heap at the start of `room`, the worst on top
  const GroupScene* group = nullptr;
};

struct RegionContext {
  CollisionScene::Impl* impl;
  const Aabb* region;
  Vec3 center;
  double radius;
  std::size_t most;  // more are not wanted,
  Failure* failure;
  std::vector<std::size_t> found;  // and the search ends with one more
  bool ended = false;
  const GroupScene* group = nullptr;
};

// One point-query callback serves both kinds of query and both levels.
struct PointContext {
  NearestContext* nearest = nullptr;
  RegionContext* region = nullptr;
  bool top = true;
  double slack = 0;  // what the ball in float exceeds the radius by, in metres
};

void search(const EmbreeBoxes& boxes, const Vec3& p, double radius, PointContext& context) {
  context.slack = slack_at(boxes, p);
  near(boxes, p, radius + context.slack, &context);
}

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

void search_group(NearestContext& context, const GroupScene& group) {
  context.group = &group;
  PointContext inner{&context, nullptr, false};
  if (context.room.size() > 1) {
    search(group.embree, context.point, context.radius, inner);
    return;
  }
  // A search for one starts from a box that is likely near.
  std::atomic<std::uint32_t>& hint = group.hints.at(context.point);
  const std::uint32_t known = hint.load(std::memory_order_relaxed);
  if (known != NearestHints::kNone) {
    const double hinted = distance(context.point, group.without_margin(known));
    context.radius = std::min(context.radius, hinted);
  }
  search(group.embree, context.point, context.radius, inner);
  if (known == NearestHints::kNone && context.found == 1) group.remember(context.room[0].box, hint);
}

void search_group(RegionContext& context, const GroupScene& group) {
  context.group = &group;
  PointContext inner{nullptr, &context, false};
  search(group.embree, context.center, context.radius, inner);
}

bool visit_nearest(RTCPointQueryFunctionArguments* args, NearestContext& context, bool top,
                   double slack) {
  const double before = context.radius;
  if (!top) {
    visit_nearest_box(context, args->primID);
  } else {
    if (distance(context.point, context.impl->group_extent[args->primID]) > context.radius) {
      return false;
    }
    visit(*context.impl, args->primID,
          [&](const GroupScene& group) { search_group(context, group); });
  }
  if (context.radius == before) return false;
  args->query->radius = float_up(std::max(0.0, context.radius + slack));
  return true;
}

bool visit_region(RTCPointQueryFunctionArguments* args, RegionContext& context, bool top) {
  if (context.ended) return false;
  if (!top) {
    if (overlap(*context.region, context.group->grown[args->primID])) {
      context.found.push_back(context.group->box[args->primID]);
      context.ended = context.found.size() > context.most;
    }
  } else if (overlap(*context.region, context.impl->group_extent[args->primID])) {
    visit(*context.impl, args->primID,
          [&](const GroupScene& group) { search_group(context, group); });
  }
  if (!context.ended) return false;
  args->query->radius = 0;  // leaves little to visit
  return true;
}

}  // namespace

bool visit_candidate(RTCPointQueryFunctionArguments* args) noexcept {
  const auto& context = *static_cast<PointContext*>(args->userPtr);
  try {
    if (context.nearest) return visit_nearest(args, *context.nearest, context.top, context.slack);
    return visit_region(args, *context.region, context.top);
  } catch (...) {
    (context.nearest ? context.nearest->failure : context.region->failure)->keep_current();
  }
  // What is still called looks at nothing.
  if (context.nearest) context.nearest->radius = -1;
  if (context.region) context.region->ended = true;
  args->query->radius = 0;
  return true;
}

std::size_t find_nearest(CollisionScene::Impl& impl, const Vec3& p, double radius,
                         std::span<Nearest> room) {
  Failure failure;
  NearestContext context{&impl, p, room, radius, &failure};
  if (impl.groups.size() == 1) {
    search_group(context, impl.touch(0));
  } else {
    PointContext point{&context, nullptr, true};
    search(impl.top, p, radius, point);
  }
  failure.rethrow();
  std::sort_heap(room.begin(), room.begin() + static_cast<std::ptrdiff_t>(context.found), closer);
  return context.found;
}

std::optional<std::vector<std::size_t>> find_meeting(CollisionScene::Impl& impl, const Aabb& region,
                                                     std::size_t most) {
  const Vec3 center = 0.5 * (region.min + region.max);
  const double radius = 0.5 * (region.max - region.min).norm() * (1 + 1e-12) + 1e-9;
  Failure failure;
  RegionContext context{&impl, &region, center, radius, most, &failure, {}};
  if (impl.groups.size() == 1) {
    search_group(context, impl.touch(0));
  } else {
    PointContext point{nullptr, &context, true};
    search(impl.top, center, radius, point);
  }
  failure.rethrow();
  if (context.found.size() > most) return std::nullopt;
  std::sort(context.found.begin(), context.found.end());
  return std::move(context.found);
}

}  // namespace geom
