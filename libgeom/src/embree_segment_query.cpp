#include "embree_queries.h"
#include "geom/separation.h"

namespace geom {
namespace {

struct SegmentContext {
  RTCIntersectContext rtc;
  CollisionScene::Impl* impl;
  const Vec3* a;
  const Vec3* b;
  const GroupScene* group;
};

bool hits_group(const SegmentContext& outer, const GroupScene& group) {
  if (group.skyline.clears(*outer.a, *outer.b)) return false;
  SegmentContext inner = outer;
  rtcInitIntersectContext(&inner.rtc);
  inner.group = &group;
  return occluded(group.embree, *outer.a, *outer.b, inner.rtc);
}

}  // namespace

void segment_against_box(const RTCOccludedFunctionNArguments* args) {
  if (!args->valid[0]) return;
  const auto& context = *reinterpret_cast<const SegmentContext*>(args->context);
  if (segment_hits(*context.a, *context.b, context.group->grown[args->primID])) mark_hit(args);
}

void segment_against_group(const RTCOccludedFunctionNArguments* args) {
  if (!args->valid[0]) return;
  const auto& outer = *reinterpret_cast<const SegmentContext*>(args->context);
  if (!segment_hits(*outer.a, *outer.b, outer.impl->group_extent[args->primID])) return;
  const Visit visit(*outer.impl, args->primID);
  if (hits_group(outer, visit.scene())) mark_hit(args);
}

bool hits_any(CollisionScene::Impl& impl, const Vec3& a, const Vec3& b) {
  SegmentContext context{{}, &impl, &a, &b, nullptr};
  // The only group is never given up.
  if (impl.groups.size() == 1) return hits_group(context, impl.touch(0));
  rtcInitIntersectContext(&context.rtc);
  return occluded(impl.top, a, b, context.rtc);
}

}  // namespace geom
