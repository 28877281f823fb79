#include "grid.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "cli/file/files.h"
#include "cli/file/made_elsewhere.h"
#include "cli/option/option_check.h"
#include "geom/collision/height_grid.h"
#ifdef SKYWAY_FOOTPRINTS
#include "geom/gis/geotiff.h"
#endif

namespace querying {
namespace {

constexpr double kMostCells = 1e8;

geom::CellGrid2 grid_over(const geom::Aabb& bounds, double cell) {
  geom::CellGrid2 out{.corner = bounds.min.head<2>(), .cell = cell};
  const geom::Vec3 size = bounds.max - bounds.min;
  const double columns = std::ceil(size.x() / cell);
  const double rows = std::ceil(size.y() / cell);
  if (columns * rows > kMostCells) {
    throw cli::UsageError(
        fmt::format("--cell: {} x {} cells are more than this tool makes (1e8): give larger ones",
                    columns, rows));
  }
  out.columns = static_cast<std::size_t>(columns);
  out.rows = static_cast<std::size_t>(rows);
  return out;
}

#ifdef SKYWAY_FOOTPRINTS

std::string geotiff(const geom::gis::NumberGrid& grid, const geom::Frame& frame) {
  return cli::made_elsewhere(
      ".tif", [&](const std::string& path) { geom::gis::write_geotiff(path, grid, frame); });
}

#endif

}  // namespace

void Grid::add_to(CLI::App& app) {
  app.add_option(
         "--grid", what_,
         "write a GeoTIFF in place of answers: heights, the highest stretch of heights that "
         "is free anywhere in a cell; distance, to the nearest obstacle at --at-height")
      ->check(CLI::IsMember({"heights", "distance"}));
  app.add_option("--cell", cell_, "metres that a cell of the grid is wide (default 5)")
      ->check(CLI::Range(1e-2, 1e5));
  app.add_option("--at-height", height_, "metres in the map's z at which distances are taken");
}

void Grid::refuse_idle(const CLI::App& app) const {
  cli::only_for(app, asked(), {"--cell"}, "--grid");
  cli::only_for(app, what_ == "distance", {"--at-height"}, "--grid distance");
  cli::only_for(app, !asked(), {"file", "--degrees", "--metres"}, "answers to questions");
  if (what_ == "distance" && !height_) {
    throw cli::UsageError("--grid distance: say at which height with --at-height");
  }
}

void Grid::write(const geom::CollisionScene& scene, const std::string& output,
                 const geom::Execution& run) const {
#ifdef SKYWAY_FOOTPRINTS
  const geom::Frame& frame = scene.map().spec().frame;
  const geom::CellGrid2 grid = grid_over(scene.map().spec().bounds, cell_);
  geom::gis::NumberGrid numbers = geom::gis::number_grid(grid, frame.axes);
  const auto add = [&](const char* name, std::string what, const std::vector<double>& values) {
    numbers.bands.push_back(
        {name, std::move(what), geom::gis::from_north(grid, frame.axes, values)});
  };
  if (what_ == "heights") {
    const geom::FreeHeights heights = geom::free_heights(scene, grid, run);
    add("highest",
        "m in the map's z: up to here the reference point is free in all of the "
        "cell, from lowest on",
        heights.highest);
    add("lowest", "m in the map's z: from here on it is free, up to highest", heights.lowest);
  } else {
    add("distance",
        fmt::format("m: no obstacle is nearer to the vehicle at z = {:g} m anywhere in the cell",
                    *height_),
        geom::distances_at(scene, grid, *height_, run));
  }
  cli::OutputFile out(output, cli::OutputKind::artefact);
  out.stream() << geotiff(numbers, frame);
  out.commit();
#else
  (void)scene, (void)output, (void)run;
  throw std::runtime_error(
      "--grid needs GDAL, and this build of Skyway is without it (SKYWAY_FOOTPRINTS)");
#endif
}

}  // namespace querying
