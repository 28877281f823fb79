#include "column_layers.h"

#include <algorithm>
#include <tuple>

#include "../shape/orientation.h"
#include "shape/row_merge.h"

namespace geom {
namespace {

ColumnLayer layer_of(const SurfaceRun& run) {
  return {run.low, run.low_most, run.high_least, run.high};
}

// Of two layers over the same cells.
void unite(ColumnLayer& into, const ColumnLayer& other) {
  into.low = std::min(into.low, other.low);
  into.low_most = std::min(into.low_most, other.low_most);
  into.high_least = std::max(into.high_least, other.high_least);
  into.high = std::max(into.high, other.high);
}

// How often the directed edge of a surface, seen from above, turns to the left of the point that is
// just right of (x, y), and above it by less.
int turns(const Vec3& a, const Vec3& b, double x, double y) {
  if ((a.y() <= y) == (b.y() <= y)) return 0;
  const int side = orientation(a.x(), a.y(), b.x(), b.y(), x, y);
  if (a.y() <= y) return side > 0 ? 1 : 0;
  return side < 0 ? -1 : 0;
}

}  // namespace

bool JoinLayers::operator()(ColumnLayers& into, const ColumnLayers& other) const {
  if (into.size() != other.size()) return false;
  for (std::size_t i = 0; i < into.size(); ++i) {
    const ColumnLayer& a = into[i];
    const ColumnLayer& b = other[i];
    if (std::max(a.low_most, b.low_most) - std::min(a.low, b.low) > rise) return false;
    if (std::max(a.high, b.high) - std::min(a.high_least, b.high_least) > rise) return false;
  }
  for (std::size_t i = 0; i < into.size(); ++i) {
    ColumnLayer& a = into[i];
    const ColumnLayer& b = other[i];
    a.low = std::min(a.low, b.low);
    a.low_most = std::max(a.low_most, b.low_most);
    a.high_least = std::min(a.high_least, b.high_least);
    a.high = std::max(a.high, b.high);
  }
  return true;
}

// Of the run's triangle around the place just inside the cell's lower corner: 0, 1 or -1. Edges
// that are gone along both ways give 0 together, so those of a closed surface add up to the winding
// number of whatever lies above.
int LayerBoxes::winding(const SurfaceRun& run, long cell) const {
  const double x = grid_.at(cell);
  const double y = grid_.at(run.row);
  const auto& corners = mesh_.triangles[run.triangle].corners;
  const Vec3& a = mesh_.vertices[corners[0]];
  const Vec3& b = mesh_.vertices[corners[1]];
  const Vec3& c = mesh_.vertices[corners[2]];
  return turns(a, b, x, y) + turns(b, c, x, y) + turns(c, a, x, y);
}

ColumnLayers LayerBoxes::filled_down(const Runs& over) const {
  ColumnLayer all = layer_of(*over.front());
  for (const SurfaceRun* run : over) unite(all, layer_of(*run));
  const double z = group_.down_to;
  unite(all, {z, z, z, z});
  return {all};
}

// Of the runs that are over all cells from `cell` on. Between two layers there is no surface, so it
// is inside or free as a whole. Gaps that are nowhere further than the rise from a surface below or
// above count as no gaps.
ColumnLayers LayerBoxes::layers(Runs& over, long cell) const {
  if (group_.fill == SolidFill::down_to) return filled_down(over);
  std::sort(over.begin(), over.end(), [](const SurfaceRun* a, const SurfaceRun* b) {
    return std::tuple(a->low, a->triangle) < std::tuple(b->low, b->triangle);
  });
  const bool fill = group_.fill == SolidFill::inside;
  ColumnLayers out;
  int around = 0;
  for (const SurfaceRun* run : over) {
    const ColumnLayer next = layer_of(*run);
    const bool one = !out.empty() && (next.low <= out.back().high || around != 0 ||
                                      next.low_most - out.back().high_least <= 2 * grid_.rise);
    if (one) {
      unite(out.back(), next);
    } else {
      out.push_back(next);
    }
    if (fill) around += winding(*run, cell);
  }
  return out;
}

template <class Merge>
void LayerBoxes::add_row(std::span<const SurfaceRun> row, Merge& merge) const {
  Runs over;
  std::size_t next = 0;
  for (long cell = row.front().cells.first; next < row.size() || !over.empty();) {
    if (over.empty()) cell = std::max(cell, row[next].cells.first);
    while (next < row.size() && row[next].cells.first <= cell) over.push_back(&row[next++]);
    long last = over.front()->cells.last;
    for (const SurfaceRun* run : over) last = std::min(last, run->cells.last);
    if (next < row.size()) last = std::min(last, row[next].cells.first);
    merge.add(row.front().row, cell, last, layers(over, cell));
    cell = last;
    std::erase_if(over, [&](const SurfaceRun* run) { return run->cells.last <= cell; });
  }
}

// Outside the limits there is neither surface nor solid.
void LayerBoxes::add_box(const Aabb& box, std::vector<Aabb>& out) const {
  const Aabb kept{box.min.cwiseMax(group_.limits.min), box.max.cwiseMin(group_.limits.max)};
  if ((kept.min.array() <= kept.max.array()).all()) out.push_back(kept);
}

std::vector<Aabb> LayerBoxes::boxes(std::span<const SurfaceRun> runs) const {
  std::vector<Aabb> out;
  const auto emit = [&](const CellRectangle<ColumnLayers>& r) {
    for (const ColumnLayer& layer : r.value) {
      add_box({{grid_.at(r.first_column), grid_.at(r.first_row), layer.low},
               {grid_.at(r.last_column), grid_.at(r.last_row), layer.high}},
              out);
    }
  };
  RowMerge<ColumnLayers, decltype(emit), JoinLayers> merge(emit, JoinLayers{grid_.rise});
  for (std::size_t first = 0, last; first < runs.size(); first = last) {
    for (last = first; last < runs.size() && runs[last].row == runs[first].row;) ++last;
    add_row(runs.subspan(first, last - first), merge);
  }
  merge.finish();
  return out;
}

}  // namespace geom
