#include "embree_queries.h"
#include "geom/shape/separation.h"

namespace geom {
namespace {

struct SegmentContext {
  RTCIntersectContext rtc;
  CollisionScene::Impl* impl;
  const Vec3* a;
  const Vec3* b;
  Failure* failure;
  const GroupScene* group;
};

bool hits_group(const SegmentContext& outer, const GroupScene& group) {
  if (group.skyline.clears(*outer.a, *outer.b)) return false;
  SegmentContext inner = outer;
  rtcInitIntersectContext(&inner.rtc);
  inner.group = &group;
  return occluded(group.embree, *outer.a, *outer.b, inner.rtc);
}

// Marks a hit where there is one, and where it cannot be told: that ends the search, on both
// levels.
template <class Decide>
void decide(const RTCOccludedFunctionNArguments* args, const SegmentContext& context,
            const Decide& hit) noexcept {
  try {
    if (hit()) mark_hit(args);
  } catch (...) {
    context.failure->keep_current();
    mark_hit(args);
  }
}

}  // namespace

void segment_against_box(const RTCOccludedFunctionNArguments* args) noexcept {
  if (!args->valid[0]) return;
  const auto& context = *reinterpret_cast<const SegmentContext*>(args->context);
  decide(args, context,
         [&] { return segment_hits(*context.a, *context.b, context.group->grown[args->primID]); });
}

void segment_against_group(const RTCOccludedFunctionNArguments* args) noexcept {
  if (!args->valid[0]) return;
  const auto& outer = *reinterpret_cast<const SegmentContext*>(args->context);
  decide(args, outer, [&] {
    if (!segment_hits(*outer.a, *outer.b, outer.impl->group_extent[args->primID])) return false;
    return visit(*outer.impl, args->primID,
                 [&](const GroupScene& group) { return hits_group(outer, group); });
  });
}

bool hits_any(CollisionScene::Impl& impl, const Vec3& a, const Vec3& b) {
  Failure failure;
  SegmentContext context{{}, &impl, &a, &b, &failure, nullptr};
  bool hit = false;
  if (impl.groups.size() == 1) {
    hit = hits_group(context, impl.touch(0));  // the only group is never given up
  } else {
    rtcInitIntersectContext(&context.rtc);
    hit = occluded(impl.top, a, b, context.rtc);
  }
  failure.rethrow();
  return hit;
}

}  // namespace geom
