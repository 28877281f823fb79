#pragma once

// What is asked of the two levels, and how candidates are decided: in double, by the functions of
// shape. Answers as CollisionScene's; callers see to it that there is a group.

#include <optional>
#include <span>
#include <vector>

#include "groups.h"

namespace geom {

bool hits_any(CollisionScene::Impl& impl, const Vec3& a, const Vec3& b);
std::optional<Aabb> blocking_box(CollisionScene::Impl& impl, const Vec3& a, const Vec3& b);
std::vector<std::size_t> blocking_boxes(CollisionScene::Impl& impl, const Vec3& a, const Vec3& b);
std::size_t find_nearest(CollisionScene::Impl& impl, const Vec3& p, double radius,
                         std::span<Nearest> room);
std::optional<std::vector<std::size_t>> find_meeting(CollisionScene::Impl& impl, const Aabb& region,
                                                     std::size_t most);

}  // namespace geom
