#include "geom/map/outer_walls.h"

namespace geom {
namespace {

constexpr double kThin = 0.15;  // of the room
constexpr double kNear = 0.05;  // of the room
constexpr double kWide = 0.5;   // of the side

// Whether the box closes the lower (or upper) side on that axis.
bool closes(const Aabb& box, const Aabb& bounds, int axis, bool upper) {
  const Vec3 room = bounds.max - bounds.min;
  const Vec3 size = box.max - box.min;
  for (int k = 0; k < 3; ++k) {
    if (k != axis && size[k] < kWide * room[k]) return false;
  }
  const double away = upper ? bounds.max[axis] - box.max[axis] : box.min[axis] - bounds.min[axis];
  return size[axis] <= kThin * room[axis] && away <= kNear * room[axis];
}

}  // namespace

std::vector<RoomSide> outer_walls(std::span<const Aabb> boxes, const Aabb& bounds) {
  std::vector<RoomSide> out;
  for (const Aabb& box : boxes) {
    out.push_back(closes(box, bounds, 0, false)   ? RoomSide::west
                  : closes(box, bounds, 0, true)  ? RoomSide::east
                  : closes(box, bounds, 1, false) ? RoomSide::south
                  : closes(box, bounds, 1, true)  ? RoomSide::north
                  : closes(box, bounds, 2, true)  ? RoomSide::top
                                                  : RoomSide::none);
  }
  return out;
}

bool hides_room(RoomSide side, const Aabb& wall, const Vec3& eye) {
  switch (side) {
    case RoomSide::west:
      return eye.x() < wall.max.x();
    case RoomSide::east:
      return eye.x() > wall.min.x();
    case RoomSide::south:
      return eye.y() < wall.max.y();
    case RoomSide::north:
      return eye.y() > wall.min.y();
    case RoomSide::top:
      return eye.z() > wall.min.z();
    case RoomSide::none:
      break;
  }
  return false;
}

}  // namespace geom
