#include "surface_runs.h"

#include <limits>
#include <tuple>

namespace geom {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

// Where the segment crosses the plane y = `y`, which is between its ends: off by less than 12 units
// of rounding of the largest coordinate, on each axis.
Vec3 crossing(const Vec3& a, const Vec3& b, double y) {
  const double share = std::clamp((y - a.y()) / (b.y() - a.y()), 0.0, 1.0);
  Vec3 p = a + share * (b - a);
  p.y() = y;
  return p;
}

}  // namespace

// The corners are those of the triangle within the row, and the crossings of its own sides:
// nothing is cut twice, so errors do not add up.
SurfaceRuns::Piece SurfaceRuns::piece_of(const TriangleCorners& corners, long row) const {
  const double low = grid_.at(row);
  const double high = grid_.at(row + 1);
  Piece piece;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& a = corners[i];
    const Vec3& b = corners[(i + 1) % 3];
    if (a.y() >= low && a.y() <= high) piece.add(a);
    const bool crosses_low = (a.y() < low) != (b.y() < low);
    const bool crosses_high = (a.y() > high) != (b.y() > high);
    const bool up = a.y() < b.y();
    if (up && crosses_low) piece.add(crossing(a, b, low));
    if (crosses_high) piece.add(crossing(a, b, high));
    if (!up && crosses_low) piece.add(crossing(a, b, low));
  }
  return piece;
}

// Over the cells, and over a strip of the reach beside them: whatever is off by rounding when the
// piece was cut, and here, is in.
SurfaceRuns::Heights SurfaceRuns::heights(const Piece& piece, CellRange cells) const {
  const double left = grid_.at(cells.first) - grid_.reach;
  const double right = grid_.at(cells.last) + grid_.reach;
  Heights out{kNone, -kNone};
  const auto include = [&](double z) {
    out.low = std::min(out.low, z);
    out.high = std::max(out.high, z);
  };
  for (std::size_t i = 0; i < piece.count; ++i) {
    const Vec3& a = piece.corners[i];
    const Vec3& b = piece.corners[i + 1 < piece.count ? i + 1 : 0];
    if (a.x() >= left && a.x() <= right) include(a.z());
    for (const double x : {left, right}) {
      if ((a.x() < x) == (b.x() < x)) continue;
      const double share = std::clamp((x - a.x()) / (b.x() - a.x()), 0.0, 1.0);
      include(a.z() + share * (b.z() - a.z()));
    }
  }
  return {out.low - grid_.reach, out.high + grid_.reach};
}

// Whether the cells can be one run, and that: over a convex piece, the lowest heights of its cells
// are convex, and the highest concave, so that the first and last cell tell of all.
bool SurfaceRuns::as_run(const Piece& piece, CellRange cells, const Heights& first,
                         SurfaceRun& run) const {
  const Heights last = heights(piece, {cells.last - 1, cells.last});
  const Heights all = heights(piece, cells);
  const double low_most = std::max(first.low, last.low);
  const double high_least = std::min(first.high, last.high);
  if (low_most - all.low > grid_.rise || all.high - high_least > grid_.rise) return false;
  run.cells = cells;
  run.low = all.low;
  run.low_most = low_most;
  run.high_least = high_least;
  run.high = all.high;
  return true;
}

// From the first of the cells on. Where a number of cells is too many, more are: found by doubling,
// then halving.
SurfaceRun SurfaceRuns::longest_run(const Piece& piece, CellRange cells) const {
  const Heights first = heights(piece, {cells.first, cells.first + 1});
  SurfaceRun run;
  run.cells = {cells.first, cells.first + 1};
  run.low = run.low_most = first.low;
  run.high = run.high_least = first.high;
  if (cells.last == run.cells.last || as_run(piece, cells, first, run)) return run;
  long too_many = cells.last - cells.first;
  for (long count = 2; count < too_many; count *= 2) {
    if (!as_run(piece, {cells.first, cells.first + count}, first, run)) too_many = count;
  }
  for (long good = run.cells.last - cells.first; too_many - good > 1;) {
    const long count = good + (too_many - good) / 2;
    (as_run(piece, {cells.first, cells.first + count}, first, run) ? good : too_many) = count;
  }
  return run;
}

void SurfaceRuns::add_piece(const Piece& piece, long row, std::uint32_t triangle) {
  double left = kNone;
  double right = -kNone;
  for (std::size_t i = 0; i < piece.count; ++i) {
    left = std::min(left, piece.corners[i].x());
    right = std::max(right, piece.corners[i].x());
  }
  const auto empty = [&](long cell) {
    const Heights h = heights(piece, {cell, cell + 1});
    return h.low > h.high;
  };
  CellRange cells{std::max(columns_.first, grid_.last_from(left - grid_.reach)),
                  std::min(columns_.last, grid_.last_from(right + grid_.reach) + 1)};
  // A cell at either end that is no nearer than the reach, which rounding took for nearer.
  while (cells.first < cells.last && empty(cells.first)) ++cells.first;
  while (cells.first < cells.last && empty(cells.last - 1)) --cells.last;
  while (cells.first < cells.last) {
    SurfaceRun run = longest_run(piece, cells);
    run.row = row;
    run.triangle = triangle;
    runs_.push_back(run);
    cells.first = run.cells.last;
  }
}

void SurfaceRuns::add(const TriangleCorners& corners, std::uint32_t triangle) {
  const auto [low, high] = std::minmax({corners[0].y(), corners[1].y(), corners[2].y()});
  const long first = std::max(rows_.first, grid_.first_to(low));
  const long last = std::min(rows_.last, grid_.last_from(high) + 1);
  for (long row = first; row < last; ++row) {
    const Piece piece = piece_of(corners, row);
    if (piece.count > 0) add_piece(piece, row, triangle);
  }
}

std::vector<SurfaceRun> SurfaceRuns::sorted() && {
  const auto key = [](const SurfaceRun& run) {
    return std::tuple(run.row, run.cells.first, run.triangle);
  };
  std::sort(runs_.begin(), runs_.end(),
            [&](const SurfaceRun& a, const SurfaceRun& b) { return key(a) < key(b); });
  return std::move(runs_);
}

double most_runs(const TriangleCorners& corners, const CoverGrid& grid) {
  const Vec3 low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]);
  const Vec3 high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
  const Vec3 a = corners[1] - corners[0];
  const Vec3 b = corners[2] - corners[0];
  const Vec3 size = (high - low) / grid.pitch;  // in cells
  const double area = 0.5 * std::abs(a.x() * b.y() - a.y() * b.x()) / (grid.pitch * grid.pitch);
  const double cells = area + 2 * (size.x() + size.y()) + 2;
  const double steps = (size.y() + 1) * (3 + 4 * (high.z() - low.z()) / grid.rise);
  return std::min(cells, steps);
}

}  // namespace geom
