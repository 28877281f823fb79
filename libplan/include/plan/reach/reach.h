#pragma once

// Decides exactly whether there is any way between two places, by cells of free space.
//
// Example:
//   plan::Reach reach(scene);
//   const plan::ReachResult result = reach.ask({1, 1, 1}, {9, 1, 1});
//   assert(result.answer == plan::Reachable::yes);
//   const geom::Polyline way = plan::way_through(result.cells, {1, 1, 1}, {9, 1, 1});
//
// Free space is where the reference point may be: CollisionScene::free_bounds(), closed, less the
// closed grown boxes. It is cut into cells that are free inside, as the leaves of a k-d tree, which
// is built only where a question looks: at faces of these boxes, or, while a region meets thousands
// of them, in the middle. Two cells are neighbours where
// they share a part of a face that has an area. This misses nothing: around a free point no cell is
// blocked, since blocked cells lie in closed boxes, and so all cells around it are joined by faces.
// Along an axis in which the bounds are flat, cells are flat, too, and the same holds of what is
// left. Coordinates are only compared, so the answer is exact; it goes by the grown boxes as they
// are rounded (geom::grow).

#include <cstddef>
#include <memory>
#include <vector>

#include "geom/collision/collision.h"
#include "geom/shape/polyline.h"

namespace plan {

using geom::Vec3;

enum class Reachable {
  yes,
  no,
  unknown  // more cells than were allowed
};

struct ReachResult {
  Reachable answer = Reachable::unknown;
  // yes: from cell to cell; the first holds the start, the last the goal, and each shares a part of
  // a face with the next. no: all that can be reached from the start, or from the goal.
  std::vector<geom::Aabb> cells;
  bool from_start = true;     // no: whether the cells are those around the start
  std::size_t looked_at = 0;  // cells, of both ends
};

// All of free space that can be reached from one end, in cells.
struct Enclosure {
  std::vector<geom::Aabb> cells;
  bool around_start = true;  // else around the goal
};

// May be asked from several threads, one after the other. The scene must outlive it. A question
// costs what it looks at, and no more on a larger map.
class Reach {
 public:
  explicit Reach(const geom::CollisionScene& scene);
  ~Reach();

  // Both ends must be free: InputError. Looks at up to about `most` cells, best first from both
  // ends in turn, so that the smaller of two separate parts of free space decides.
  ReachResult ask(const Vec3& from, const Vec3& to, std::size_t most = kMostCells);

  static constexpr std::size_t kMostCells = 2'000'000;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// The way through the middles of cells and of the parts of faces between them. In exact numbers it
// is free; rounded, it is where the gaps are wider than some ulp: ask the scene.
geom::Polyline way_through(const std::vector<geom::Aabb>& cells, const Vec3& from, const Vec3& to);

}  // namespace plan
