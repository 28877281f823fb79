#pragma once

// The triangles of one group, cut into bands of rows that threads make boxes of.

#include <span>
#include <vector>

#include "column_layers.h"
#include "cover_grid.h"
#include "triangle_groups.h"

namespace geom {

TriangleCorners corners_of(const TriangleMesh& mesh, std::size_t triangle);

class CoverBands {
 public:
  CoverBands() = default;

  // How high a band is follows from the triangles alone.
  CoverBands(const TriangleMesh& mesh, const TriangleGroups& groups, const TriangleGroup& group,
             const TriangleCoverOptions& options, const CoverGrid& grid);

  std::size_t size() const { return triangles_.size(); }

  // Boxes that cover what the rows of a band hold of the group.
  std::vector<Aabb> boxes(const TriangleMesh& mesh, std::size_t band) const;

 private:
  void share_out(const TriangleMesh& mesh, std::span<const std::uint32_t> triangles);

  CoverGrid grid_;
  SolidGroup solid_;
  CellRange rows_;
  CellRange columns_;
  long band_rows_ = 1;
  std::vector<std::vector<std::uint32_t>> triangles_;  // that each band has rows of
};

// Boxes that one band ended with and the next began with again become one; it stays in the first.
void join_bands(std::vector<std::vector<Aabb>>& bands);

}  // namespace geom
