#pragma once

// The collision structure: exact queries of a box map for one vehicle and margin.
//
// Example:
//   const geom::CollisionScene city(map, vehicle, 0.2);  // 0.2 m of margin
//   assert(city.free({1, 1, 1}) && !city.free({1, 1, 1}, {9, 1, 1}));  // a block stands between
//   const auto nearest = city.nearest({1, 1, 1}, 50);
//   std::cout << nearest->distance << " m to box " << nearest->box << '\n';

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "geom/base/execution.h"
#include "geom/map/box_map.h"
#include "geom/shape/aabb.h"
#include "geom/shape/empty_box.h"
#include "geom/shape/separation.h"
#include "geom/vehicle/vehicle.h"

namespace geom {

// The nearest obstacle and how far it is.
struct Nearest {
  std::size_t box = 0;  // index into BoxMap::boxes()
  double distance = 0;  // metres from the point to that obstacle grown by the vehicle, without
                        // the margin; 0 inside or on it
};

struct CollisionOptions {
  std::size_t budget = std::size_t{1} << 29;  // bytes that groups of tiles may take
  std::size_t boxes_per_group = 0;            // about; 0: as many as measured fastest
};

// What queries made a scene do so far.
struct CollisionCounts {
  std::size_t groups = 0;       // of tiles
  std::size_t built = 0;        // of them
  std::size_t built_again = 0;  // how often one was that had been given up
  std::size_t most_bytes = 0;   // that they took at a time
};

// Holds the map, grown by vehicle and margin (geom::grow). A group of neighbouring tiles is built
// when a query first touches it. When all groups together take more than the budget, those that
// were not touched for long are dropped. All queries are const and may run from several
// threads at once. Answers are exact for the grown boxes, and ties break on the lowest index.
//
// A query that fails throws, and gives no answer. It throws InputError if a tile of a
// mapped file that it touches holds a wrong value, and std::bad_alloc if there is no memory for
// a group; the next query builds the group anew. Points must be within kFarthest
// (geom/base/precondition.h), lengths >= 0, and regions have min <= max; otherwise, and for NaN,
// a query throws InputError. Regions and radii may be infinite.
class CollisionScene {
 public:
  // `margin` in metres is added to each half size. InputError if the margin or a half size is not
  // within 0 and kLargestCoordinate, or if the map's extent is not valid.
  CollisionScene(BoxMap map, Vehicle vehicle, double margin, const CollisionOptions& options = {});
  ~CollisionScene();
  CollisionScene(CollisionScene&&) noexcept;
  CollisionScene& operator=(CollisionScene&&) noexcept;

  const BoxMap& map() const;
  const Vehicle& vehicle() const;
  double margin() const;
  Vec3 half() const;  // vehicle half sizes plus margin, rounded up

  // Where the reference point may be (geom::shrink of the map's bounds); nothing when the vehicle
  // does not fit.
  const std::optional<Aabb>& free_bounds() const;
  bool inside_bounds(const Vec3& p) const;  // false for a point that is not finite

  // Whether the closed segment (or point, a == b) meets a grown box. Bounds do not matter.
  bool hits(const Vec3& a, const Vec3& b) const;
  bool hits(const Vec3& p) const { return hits(p, p); }

  // A grown box that the closed segment meets, or nothing: see hits(). If there are several, it may
  // be any of them, and another one in the next run.
  std::optional<Aabb> blocker(const Vec3& a, const Vec3& b) const;

  // Indices, ascending, of all boxes whose grown boxes meet the closed segment: see hits().
  std::vector<std::size_t> blockers(const Vec3& a, const Vec3& b) const;

  // Inside the bounds at both ends and free of every grown box. False for points outside, at any
  // distance.
  bool free(const Vec3& a, const Vec3& b) const;
  bool free(const Vec3& p) const { return free(p, p); }

  // Whether the closed box of half sizes `half` (in place of vehicle and margin), moved along the
  // segment, meets an obstacle grown by it (geom::grow).
  bool sweep_hits(const Vec3& a, const Vec3& b, const Vec3& half) const;

  // hits() of many segments, 1 where it is true.
  std::vector<std::uint8_t> hits(std::span<const std::pair<Vec3, Vec3>> segments,
                                 const Execution& run) const;

  // The nearest obstacle within `radius` metres (closed; below 0 holds none), or nothing.
  std::optional<Nearest> nearest(const Vec3& p, double radius) const;

  // The `count` nearest obstacles within `radius`, nearest first; fewer where there are no more.
  std::vector<Nearest> nearest(const Vec3& p, double radius, std::size_t count) const;

  // The same into memory of the caller's: as many as there is room for. Returns how many.
  std::size_t nearest(const Vec3& p, double radius, std::span<Nearest> room) const;

  // Indices, ascending, of the boxes whose grown boxes meet the closed region.
  std::vector<std::size_t> boxes_meeting(const Aabb& region) const;

  // The same, or nothing where there are more than `most`; costs no more than finding those.
  std::optional<std::vector<std::size_t>> boxes_meeting(const Aabb& region, std::size_t most) const;

  // Planes to the grown boxes within `reach` metres of the segment, nearest first (ties: the lower
  // index). Each separates the whole segment from its box where its gap is > 0.
  struct Separated {
    std::size_t box = 0;
    Separation separation;
  };
  std::vector<Separated> separating_planes(const Vec3& a, const Vec3& b, double reach) const;

  // The largest box around the segment, within `reach` metres of its bounding box and inside the
  // bounds, that the reference point may use: see geom::empty_box.
  std::optional<EmptyBox> empty_box(const Vec3& a, const Vec3& b, double reach) const;

  // grow(map().box(i), half()).
  Aabb grown(std::size_t i) const;

  CollisionCounts counts() const;

  struct Impl;  // of the files in libgeom/src/collision alone

 private:
  std::unique_ptr<Impl> impl_;
};

}  // namespace geom
