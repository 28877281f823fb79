#pragma once

// What is asked of the two levels, and how Embree's candidates are decided. Answers as
// CollisionScene's; callers see to it that there is a group.

#include <optional>
#include <span>
#include <vector>

#include "embree_groups.h"

namespace geom {

bool hits_any(CollisionScene::Impl& impl, const Vec3& a, const Vec3& b);
std::size_t find_nearest(CollisionScene::Impl& impl, const Vec3& p, double radius,
                         std::span<Nearest> room);
std::optional<std::vector<std::size_t>> find_meeting(CollisionScene::Impl& impl, const Aabb& region,
                                                     std::size_t most);

// Embree's callbacks: a box of a group against a segment, a group against it, and either against a
// point's surroundings. What goes wrong in them is kept (Failure).
void segment_against_box(const RTCOccludedFunctionNArguments* args) noexcept;
void segment_against_group(const RTCOccludedFunctionNArguments* args) noexcept;
bool visit_candidate(RTCPointQueryFunctionArguments* args) noexcept;

}  // namespace geom
