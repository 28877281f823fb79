#include "cover_bands.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace geom {
namespace {

constexpr double kPiecesOfBand = 65536;

}  // namespace

TriangleCorners corners_of(const TriangleMesh& mesh, std::size_t triangle) {
  const auto& corners = mesh.triangles[triangle].corners;
  return {mesh.vertices[corners[0]], mesh.vertices[corners[1]], mesh.vertices[corners[2]]};
}

CoverBands::CoverBands(const TriangleMesh& mesh, const TriangleGroups& groups,
                       const TriangleGroup& group, const TriangleCoverOptions& options,
                       const CoverGrid& grid)
    : grid_(grid) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::span triangles = std::span(groups.triangles).subspan(group.first, group.count);
  Aabb& all = solid_.limits;
  all = {Vec3::Constant(kInfinity), Vec3::Constant(-kInfinity)};
  double pieces = 0;
  for (const std::uint32_t t : triangles) {
    const TriangleCorners corners = corners_of(mesh, t);
    for (const Vec3& v : corners) all = {all.min.cwiseMin(v), all.max.cwiseMax(v)};
    pieces += most_runs(corners, grid);
  }
  columns_ = grid.around(all.min.x(), all.max.x());
  rows_ = grid.around(all.min.y(), all.max.y());
  if (group.closed) solid_.fill = SolidFill::inside;
  if (options.fill == SolidFill::down_to) {
    const double z = options.down_to[group.part];
    solid_.fill = SolidFill::down_to;
    solid_.down_to = z;
    all.min.z() = std::min(all.min.z(), z);
    all.max.z() = std::max(all.max.z(), z);
  }
  const auto rows = static_cast<double>(rows_.last - rows_.first);
  const double bands = std::clamp(std::ceil(pieces / kPiecesOfBand), 1.0, rows);
  band_rows_ = static_cast<long>(std::ceil(rows / bands));
  share_out(mesh, triangles);
}

void CoverBands::share_out(const TriangleMesh& mesh, std::span<const std::uint32_t> triangles) {
  const long last_row = rows_.last - 1;
  const auto band_of = [&](long row) {
    const long within = std::clamp(row, rows_.first, last_row) - rows_.first;
    return static_cast<std::size_t>(within / band_rows_);
  };
  triangles_.resize(band_of(last_row) + 1);
  for (const std::uint32_t t : triangles) {
    const TriangleCorners c = corners_of(mesh, t);
    const auto [low, high] = std::minmax({c[0].y(), c[1].y(), c[2].y()});
    const std::size_t last = band_of(grid_.last_from(high));
    for (std::size_t k = band_of(grid_.first_to(low)); k <= last; ++k) triangles_[k].push_back(t);
  }
}

std::vector<Aabb> CoverBands::boxes(const TriangleMesh& mesh, std::size_t band) const {
  const long first = rows_.first + static_cast<long>(band) * band_rows_;
  SurfaceRuns runs(grid_, {first, std::min(first + band_rows_, rows_.last)}, columns_);
  for (const std::uint32_t t : triangles_[band]) runs.add(corners_of(mesh, t), t);
  return LayerBoxes(mesh, grid_, solid_).boxes(std::move(runs).sorted());
}

void join_bands(std::vector<std::vector<Aabb>>& bands) {
  // Where a box goes on, upward; what else it must agree in.
  const auto key = [](const Aabb& box, double y) {
    return std::tuple(y, box.min.x(), box.max.x(), box.min.z(), box.max.z());
  };
  for (std::size_t k = bands.size(); k-- > 1;) {
    std::map<std::tuple<double, double, double, double, double>, Aabb*> below;
    for (Aabb& box : bands[k - 1]) below.emplace(key(box, box.max.y()), &box);
    std::vector<Aabb> kept;
    for (const Aabb& above : bands[k]) {
      const auto found = below.find(key(above, above.min.y()));
      if (found == below.end()) {
        kept.push_back(above);
      } else {
        found->second->max.y() = std::max(found->second->max.y(), above.max.y());
      }
    }
    bands[k] = std::move(kept);
  }
}

}  // namespace geom
