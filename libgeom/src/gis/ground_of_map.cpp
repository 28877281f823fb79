#include "geom/gis/ground_of_map.h"

#include <fmt/format.h>

#include <filesystem>
#include <limits>
#include <optional>
#include <utility>

#include "base/unchanged_file.h"
#include "geom/base/hashed_stream.h"
#include "geom/map/geographic_frame.h"
#include "required_reference.h"

namespace geom::gis {
namespace {

constexpr double kMostCells = 2.5e7;
constexpr double kAround = 1e-6;  // of a cell, that each range holds around it

// From the map's coordinates to the raster's own.
class ToRaster {
 public:
  ToRaster(const Frame& frame, const std::optional<ProjReference>& crs, const std::string& name)
      : axes_(frame.axes) {
    if (!crs && !frame.origin) return;
    if (!crs || !counts_from_origin(frame)) {
      throw InputError(name,
                       {.expected = "a height model and a map that both say where on Earth "
                                    "they are, or neither",
                        .found = crs ? "a map that does not" : "a height model that does not"});
    }
    from_raster_ = required_way(ProjWay::to_plane(*crs, *frame.origin), *crs, name);
  }

  // Infinite where PROJ cannot convert.
  std::vector<Vec2> operator()(std::vector<Vec2> points) const {
    if (!from_raster_) return points;
    if (axes_ == geom::Axes::neu) {
      for (Vec2& p : points) std::swap(p.x(), p.y());
    }
    from_raster_->back(points);
    return points;
  }

 private:
  geom::Axes axes_;
  std::optional<ProjWay> from_raster_;
};

GroundGridSpec grid_of(const std::string& path, const BoxMapSpec& spec,
                       const GroundOptions& options) {
  GroundGridSpec grid{.frame = spec.frame, .cell = options.cell, .error = options.error};
  const Vec2 low = (spec.bounds.min.head<2>() / options.cell).array().floor() - 1;
  const Vec2 high = (spec.bounds.max.head<2>() / options.cell).array().ceil() + 1;
  const Vec2 count = high - low;
  if (!(count.x() * count.y() <= kMostCells)) {
    throw InputError(path, {.expected = "at most 25 million cells over the map",
                            .found = fmt::format("{:.0f} x {:.0f}", count.x(), count.y()),
                            .advice = "give larger cells (--cell)"});
  }
  grid.corner = low * options.cell;
  grid.columns = static_cast<std::size_t>(count.x());
  grid.rows = static_cast<std::size_t>(count.y());
  grid.source = std::filesystem::path(path).filename().string();
  const auto file = options.open(path);
  grid.hash = HashedStream(*file).hash();
  return grid;
}

// The corners of a row of cells, each a hair further out, four a cell.
std::vector<Vec2> corners_of(const GroundGridSpec& grid, std::size_t row) {
  std::vector<Vec2> out;
  out.reserve(4 * grid.columns);
  for (std::size_t i = 0; i < grid.columns; ++i) {
    for (const double dx : {-kAround, 1 + kAround}) {
      for (const double dy : {-kAround, 1 + kAround}) {
        out.push_back(grid.corner +
                      grid.cell * Vec2(static_cast<double>(i) + dx, static_cast<double>(row) + dy));
      }
    }
  }
  return out;
}

}  // namespace

GroundModel ground_of_map(const std::string& path, const BoxMapSpec& spec,
                          const GroundOptions& options) {
  const UnchangedFile same(path);
  const Terrain terrain(path, path, options.read);
  const ToRaster to_raster(spec.frame, terrain.crs(), path);
  const GroundGridSpec grid = grid_of(path, spec, options);
  const double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> low(grid.columns * grid.rows, none);
  std::vector<double> high = low;
  for (std::size_t row = 0; row < grid.rows; ++row) {
    const std::vector<Vec2> corners = to_raster(corners_of(grid, row));
    for (std::size_t i = 0; i < grid.columns; ++i) {
      const auto range = terrain.surface(std::span(corners).subspan(4 * i, 4));
      if (!range) continue;
      low[row * grid.columns + i] = range->low;
      high[row * grid.columns + i] = range->high;
    }
  }
  same.require();
  return {grid, std::move(low), std::move(high)};
}

}  // namespace geom::gis
