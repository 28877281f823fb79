#include "geom/mesh/triangle_cover.h"

#include <fmt/format.h>

#include <cmath>

#include "cover_bands.h"
#include "geom/base/error.h"
#include "geom/base/parallel.h"
#include "triangle_groups.h"

namespace geom {
namespace {

constexpr std::string_view kSource = "triangles";

// The largest coordinate of any triangle. Checks them, too.
double checked_size(const TriangleMesh& mesh) {
  double largest = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t i : mesh.triangles[t].corners) {
      if (i >= mesh.vertices.size()) {
        throw InputError(kSource,
                         {.item = fmt::format("triangle {}", t),
                          .expected = fmt::format("vertices below {}", mesh.vertices.size()),
                          .found = fmt::to_string(i)});
      }
      const Vec3& v = mesh.vertices[i];
      const double size = v.cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
      if (!(size <= kLargestCoordinate)) {
        throw InputError(kSource,
                         {.item = fmt::format("triangle {}", t),
                          .expected = fmt::format("coordinates within {} m", kLargestCoordinate),
                          .found = fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z())});
      }
      largest = std::max(largest, size);
    }
  }
  return largest;
}

void check_options(const TriangleMesh& mesh, const TriangleCoverOptions& options, double largest) {
  const double least = std::max(1e-6, 1e-9 * largest);
  if (!(options.slack >= least && options.slack <= kLargestCoordinate)) {
    throw InputError(kSource,
                     {.expected = fmt::format(
                          "a slack from {} m (1e-6 m, and 1e-9 of the largest coordinate) to {} m",
                          least, kLargestCoordinate),
                      .found = fmt::to_string(options.slack)});
  }
  if (options.fill != SolidFill::down_to) return;
  for (const MeshTriangle& t : mesh.triangles) {
    if (t.part < options.down_to.size() &&
        std::abs(options.down_to[t.part]) <= kLargestCoordinate) {
      continue;
    }
    throw InputError(
        kSource, {.item = fmt::format("part {}", t.part),
                  .expected = fmt::format("a height within {} m that it is solid down to",
                                          kLargestCoordinate),
                  .found = t.part < options.down_to.size() ? fmt::to_string(options.down_to[t.part])
                                                           : "none"});
  }
}

double pieces(const TriangleMesh& mesh, const CoverGrid& grid) {
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    sum += most_runs(corners_of(mesh, t), grid);
  }
  return sum;
}

void refuse_too_many(const TriangleMesh& mesh, const TriangleCoverOptions& options,
                     double largest) {
  const double many = pieces(mesh, CoverGrid::of(options.slack, largest));
  if (many <= options.most_pieces) return;
  double slack = 2 * options.slack;
  while (slack < kLargestCoordinate &&
         pieces(mesh, CoverGrid::of(slack, largest)) > options.most_pieces) {
    slack *= 2;
  }
  throw InputError(kSource,
                   {.says = fmt::format(
                        "{} triangles would be cut into up to {:.2g} pieces for a slack of {} m, "
                        "more than {:.2g}: a slack of {} m would do, or fewer triangles at a time",
                        mesh.triangles.size(), many, options.slack, options.most_pieces, slack)});
}

}  // namespace

TriangleCover cover_triangles(const TriangleMesh& mesh, const TriangleCoverOptions& options,
                              const Execution& run) {
  const double largest = checked_size(mesh);
  check_options(mesh, options, largest);
  refuse_too_many(mesh, options, largest);
  const TriangleGroups groups =
      options.fill == SolidFill::inside ? groups_by_surface(mesh) : groups_by_part(mesh);
  const CoverGrid grid = CoverGrid::of(options.slack, largest);
  std::vector<CoverBands> bands(groups.groups.size());
  const Execution quiet{run.threads, {}};
  parallel_for(bands.size(), quiet, [&](std::size_t g) {
    bands[g] = CoverBands(mesh, groups, groups.groups[g], options, grid);
  });
  struct Task {
    std::size_t group;
    std::size_t band;
  };
  std::vector<Task> tasks;
  std::vector<std::vector<std::vector<Aabb>>> made(bands.size());  // by group, by band
  for (std::size_t g = 0; g < bands.size(); ++g) {
    made[g].resize(bands[g].size());
    for (std::size_t k = 0; k < bands[g].size(); ++k) tasks.push_back({g, k});
  }
  parallel_for(tasks.size(), run, [&](std::size_t i) {
    const auto [g, k] = tasks[i];
    made[g][k] = bands[g].boxes(mesh, k);
  });
  parallel_for(made.size(), quiet, [&](std::size_t g) { join_bands(made[g]); });
  TriangleCover out;
  for (std::size_t g = 0; g < made.size(); ++g) {
    for (const std::vector<Aabb>& band : made[g]) {
      out.boxes.insert(out.boxes.end(), band.begin(), band.end());
    }
    out.part.resize(out.boxes.size(), groups.groups[g].part);
    out.closed += groups.groups[g].closed;
    made[g].clear();
  }
  out.open = groups.open_surfaces;
  return out;
}

}  // namespace geom
