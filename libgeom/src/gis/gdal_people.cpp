#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/unchanged_file.h"
#include "base/watched_memory.h"
#include "gdal_cells.h"
#include "gdal_handles.h"
#include "gdal_whole_raster.h"
#include "geom/gis/people_raster.h"

namespace geom::gis {
namespace {

constexpr double kMostCells = 4e6;
constexpr int kSteps = 8;  // along each side of the region, for sides that bend

// A raster with its places.
class Raster {
 public:
  explicit Raster(const std::string& path) : path_(path), dataset_(opened(path, GDAL_OF_RASTER)) {
    if (!dataset_ || number_bands(dataset_) != 1) {
      refuse({.expected = "a raster of one band that counts people, as a GeoTIFF",
              .found = dataset_ ? fmt::format("{} bands", number_bands(dataset_))
                                : "a file that GDAL cannot open as one"});
    }
    require_whole_raster(dataset_, path_, path_);
    const auto own = reference_of(gdal().spatial_reference(dataset_.get()), path);
    if (!own || gdal().geo_transform(dataset_.get(), forward_) != CE_None ||
        !gdal().invert_geo_transform(forward_, inverse_)) {
      refuse({.expected = "a raster that says where on Earth its cells are",
              .found = "one that does not"});
    }
    way_ = required_way(ProjWay::to_places(*own), *own, path);
    width_ = gdal().raster_width(dataset_.get());
    height_ = gdal().raster_height(dataset_.get());
  }

  // Columns and rows, the last ones excluded.
  struct Window {
    int column = 0;
    int row = 0;
    int columns = 0;
    int rows = 0;
  };

  Window window(const Vec2& low, const Vec2& high) const {
    double c0 = std::numeric_limits<double>::infinity(), c1 = -c0, r0 = c0, r1 = -c0;
    std::vector<Vec2> points;
    for (int i = 0; i <= kSteps; ++i) {
      for (int k = 0; k <= kSteps; ++k) {
        points.emplace_back(low.y() + (high.y() - low.y()) * i / kSteps,
                            low.x() + (high.x() - low.x()) * k / kSteps);
      }
    }
    way_->back(points);
    require_places(points);
    for (const Vec2& p : points) {
      const double column = inverse_[0] + p.x() * inverse_[1] + p.y() * inverse_[2];
      const double row = inverse_[3] + p.x() * inverse_[4] + p.y() * inverse_[5];
      c0 = std::min(c0, column), c1 = std::max(c1, column);
      r0 = std::min(r0, row), r1 = std::max(r1, row);
    }
    const auto clamped = [](double v, int n) {
      return static_cast<int>(std::clamp(v, 0.0, 1.0 * n));
    };
    Window out{clamped(std::floor(c0) - 1, width_), clamped(std::floor(r0) - 1, height_)};
    out.columns = clamped(std::ceil(c1) + 1, width_) - out.column;
    out.rows = clamped(std::ceil(r1) + 1, height_) - out.row;
    if (static_cast<double>(out.columns) * out.rows > kMostCells) {
      refuse({.expected = "at most 4e6 cells below the flights",
              .found = fmt::format("{} x {}", out.columns, out.rows),
              .advice = "make a raster of larger cells, for example with `gdalwarp -r sum -tr`"});
    }
    return out;
  }

  std::vector<PeopleCell> read(const Window& at) const {
    std::vector<PeopleCell> out;
    if (at.columns <= 0 || at.rows <= 0) return out;
    std::vector<double> values(static_cast<std::size_t>(at.columns) *
                               static_cast<std::size_t>(at.rows));
    const RasterCells cells(dataset_, path_, path_);
    if (!cells.read(at.column, at.row, at.columns, at.rows, values.data())) {
      refuse({.says = fmt::format("its cells cannot be read (GDAL: {})", gdal().last_error())});
    }
    const std::vector<GeodeticPlace> nodes = places(at);
    const auto node = [&](int column, int row) {
      return nodes[static_cast<std::size_t>(row * (at.columns + 1) + column)];
    };
    for (int row = 0; row < at.rows; ++row) {
      for (int column = 0; column < at.columns; ++column) {
        PeopleCell& cell = out.emplace_back();
        cell.row = static_cast<std::size_t>(at.row + row);
        cell.column = static_cast<std::size_t>(at.column + column);
        cell.people = people(values[static_cast<std::size_t>(row * at.columns + column)], cell);
        cell.corners = {node(column, row), node(column + 1, row), node(column + 1, row + 1),
                        node(column, row + 1)};
      }
    }
    return out;
  }

 private:
  [[noreturn]] void refuse(Fault fault) const { throw InputError(path_, std::move(fault)); }

  void require_places(const std::vector<Vec2>& converted) const {
    for (const Vec2& p : converted) {
      if (!p.allFinite())
        refuse({.says = "PROJ cannot convert its coordinates to places on Earth"});
    }
  }

  // Of all corners of the window's cells.
  std::vector<GeodeticPlace> places(const Window& at) const {
    std::vector<Vec2> points;
    for (int row = at.row; row <= at.row + at.rows; ++row) {
      for (int column = at.column; column <= at.column + at.columns; ++column) {
        points.emplace_back(forward_[0] + column * forward_[1] + row * forward_[2],
                            forward_[3] + column * forward_[4] + row * forward_[5]);
      }
    }
    way_->forward(points);
    require_places(points);
    std::vector<GeodeticPlace> out;
    for (const Vec2& p : points) out.push_back({p.y(), p.x(), 0});
    return out;
  }

  std::optional<double> people(double people, const PeopleCell& cell) const {
    if (std::isnan(people)) return std::nullopt;
    if (people >= 0 && people <= 1e9) return people;
    refuse({.item = fmt::format("row {}, column {}", cell.row, cell.column),
            .expected = "a number of people, 0 or more",
            .found = fmt::to_string(people),
            .advice = "say which value stands for none (`gdal_translate -a_nodata`)"});
  }

  std::string path_;
  DatasetHandle dataset_;
  std::optional<ProjWay> way_;
  double forward_[6] = {};
  double inverse_[6] = {};
  int width_ = 0;
  int height_ = 0;
};

}  // namespace

std::vector<PeopleCell> people_within(const std::string& path, const Vec2& low, const Vec2& high) {
  const UnchangedFile same(path);
  const WatchedMemory memory;
  const Raster raster(path);
  std::vector<PeopleCell> out = raster.read(raster.window(low, high));
  memory.require_enough();
  same.require();
  return out;
}

}  // namespace geom::gis
