#pragma once

// Triangles as runs of cells, and the heights over them.

#include <array>
#include <cstdint>
#include <vector>

#include "cover_grid.h"
#include "geom/base/vec3.h"

namespace geom {

// The triangle has points over each cell of the run; over a cell, all its heights are within
// [low, high], the lowest at most low_most and the highest at least high_least.
struct SurfaceRun {
  long row = 0;
  CellRange cells;
  double low = 0;
  double low_most = 0;  // <= low + rise
  double high_least = 0;
  double high = 0;  // <= high_least + rise
  std::uint32_t triangle = 0;
};

using TriangleCorners = std::array<Vec3, 3>;

// Cuts triangles by rows. No point of them within the rows and columns is left out, whatever
// rounding does.
class SurfaceRuns {
 public:
  SurfaceRuns(const CoverGrid& grid, CellRange rows, CellRange columns)
      : grid_(grid), rows_(rows), columns_(columns) {}

  void add(const TriangleCorners& corners, std::uint32_t triangle);

  // By row, then by the first cell, then by the triangle.
  std::vector<SurfaceRun> sorted() &&;

 private:
  // What a row holds of a triangle: corners in turn. Their rounding is within half the reach.
  struct Piece {
    std::array<Vec3, 6> corners;
    std::size_t count = 0;

    void add(const Vec3& p) { corners[count++] = p; }
  };
  struct Heights {  // low > high: none
    double low;
    double high;
  };

  Piece piece_of(const TriangleCorners& corners, long row) const;
  Heights heights(const Piece& piece, CellRange cells) const;
  void add_piece(const Piece& piece, long row, std::uint32_t triangle);
  SurfaceRun longest_run(const Piece& piece, CellRange cells) const;
  bool as_run(const Piece& piece, CellRange cells, const Heights& first, SurfaceRun& run) const;

  CoverGrid grid_;
  CellRange rows_;
  CellRange columns_;
  std::vector<SurfaceRun> runs_;
};

// How many runs there may be of a triangle, about: never many fewer.
double most_runs(const TriangleCorners& corners, const CoverGrid& grid);

}  // namespace geom
