#pragma once

// What stands over a run of cells, and runs of cells that are one box.

#include <span>
#include <vector>

#include "cover_grid.h"
#include "geom/mesh/triangle_cover.h"
#include "surface_runs.h"

namespace geom {

// Heights that are not free, over a run of cells. In each cell the lowest point of the surface is
// at most low_most, the highest at least high_least.
struct ColumnLayer {
  double low = 0;
  double low_most = 0;
  double high_least = 0;
  double high = 0;
};
using ColumnLayers = std::vector<ColumnLayer>;  // ascending, apart from each other

// Makes one of two where no height then is further than `rise` from a surface in its cell.
struct JoinLayers {
  double rise = 0;  // metres

  bool operator()(ColumnLayers& into, const ColumnLayers& other) const;
};

// Of one group of triangles.
struct SolidGroup {
  SolidFill fill = SolidFill::none;  // `inside` only where the surface is closed
  double down_to = 0;
  Aabb limits;  // of its triangles, and of the solid
};

// Boxes of the runs of a group, which are sorted. `corners` are those of a triangle by its number.
class LayerBoxes {
 public:
  LayerBoxes(const TriangleMesh& mesh, const CoverGrid& grid, const SolidGroup& group)
      : mesh_(mesh), grid_(grid), group_(group) {}

  std::vector<Aabb> boxes(std::span<const SurfaceRun> runs) const;

 private:
  using Runs = std::vector<const SurfaceRun*>;

  template <class Merge>
  void add_row(std::span<const SurfaceRun> row, Merge& merge) const;
  ColumnLayers layers(Runs& over, long cell) const;
  ColumnLayers filled_down(const Runs& over) const;
  int winding(const SurfaceRun& run, long cell) const;
  void add_box(const Aabb& box, std::vector<Aabb>& out) const;

  const TriangleMesh& mesh_;
  CoverGrid grid_;
  SolidGroup group_;
};

}  // namespace geom
