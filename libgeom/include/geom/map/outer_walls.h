#pragma once

// Which boxes close a room, so that pictures from outside can cut them away.
//
// Example:
//   const std::vector<geom::Aabb> boxes = {{{0, 0, 0}, {0.2, 8, 3}}, {{4, 4, 0}, {5, 5, 3}}};
//   const auto sides = geom::outer_walls(boxes, {{0, 0, 0}, {9, 8, 3}});
//   assert(sides[0] == geom::RoomSide::west && sides[1] == geom::RoomSide::none);

#include <cstdint>
#include <span>
#include <vector>

#include "geom/shape/aabb.h"

namespace geom {

enum class RoomSide : std::uint8_t { none, west, east, south, north, top };

// Of each box the side of the bounds that it closes: it is thin (at most 15 % of the room), lies
// within 5 % of that side, and is at least half as long and half as high as the side. Boxes and
// bounds in east, north, up.
std::vector<RoomSide> outer_walls(std::span<const Aabb> boxes, const Aabb& bounds);

// Whether a wall of that side hides the room from `eye`: the eye is on its outer side.
bool hides_room(RoomSide side, const Aabb& wall, const Vec3& eye);

}  // namespace geom
