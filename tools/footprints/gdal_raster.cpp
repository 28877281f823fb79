#include <algorithm>
#include <cmath>
#include <limits>

#include "footprints/gdal_reference.h"
#include "footprints/source.h"
#include "geom/row_merge.h"

namespace footprints {
namespace {

constexpr double kMostCells = 2e9;

struct Raster {
  Dataset dataset;
  GDALRasterBand* band = nullptr;
  double transform[6];
  std::string crs;
  int width = 0;
  int height = 0;

  geom::Vec2 corner(double column, double row) const {
    return {transform[0] + column * transform[1] + row * transform[2],
            transform[3] + column * transform[4] + row * transform[5]};
  }

  // A row's heights; NaN where there is no data.
  void read_row(int row, const std::string& name, float* out) const {
    if (band->RasterIO(GF_Read, 0, row, width, 1, out, width, 1, GDT_Float32, 0, 0) != CE_None) {
      throw geom::InputError(name,
                             fmt::format("row {} cannot be read: {}", row, CPLGetLastErrorMsg()));
    }
    int has_nodata = 0;
    const auto nodata = static_cast<float>(band->GetNoDataValue(&has_nodata));
    for (int i = 0; i < width; ++i) {
      const bool missing = (has_nodata && out[i] == nodata) || !(std::abs(out[i]) <= 1e4f);
      if (missing) out[i] = std::numeric_limits<float>::quiet_NaN();
    }
  }
};

Raster open_raster(const std::string& path, const std::string& name) {
  Raster raster;
  raster.dataset = open(path, GDAL_OF_RASTER);
  if (!raster.dataset || raster.dataset->GetRasterCount() < 1) {
    throw geom::InputError(name, "expected a raster of heights, and GDAL cannot open it as one");
  }
  raster.band = raster.dataset->GetRasterBand(1);
  raster.width = raster.dataset->GetRasterXSize();
  raster.height = raster.dataset->GetRasterYSize();
  if (static_cast<double>(raster.width) * raster.height > kMostCells) {
    throw geom::InputError(name, fmt::format("expected at most 2e9 cells, found {} x {}",
                                             raster.width, raster.height));
  }
  if (raster.dataset->GetGeoTransform(raster.transform) != CE_None) {
    throw geom::InputError(name, "expected a raster that says where its cells are");
  }
  raster.crs = wkt_of(raster.dataset->GetSpatialRef());
  return raster;
}

class SurfaceReader {
 public:
  SurfaceReader(const Raster& raster, const std::string& name, const ReadOptions& options)
      : raster_(raster), name_(name), step_(options.height_step) {}

  Source read() {
    out_.crs = raster_.crs;
    geom::RowMerge<double, Add> merge(Add{*this});
    std::vector<float> cells(static_cast<std::size_t>(raster_.width));
    for (int row = 0; row < raster_.height; ++row) {
      raster_.read_row(row, name_, cells.data());
      for (int i = 0; i < raster_.width; ++i) {
        const float cell = cells[static_cast<std::size_t>(i)];
        ++out_.counts[std::isnan(cell) ? "cells_without_data" : "cells"];
        if (std::isnan(cell)) continue;
        lowest_ = std::min(lowest_, static_cast<double>(cell));
        merge.add(row, i, rounded_up(cell));
      }
    }
    merge.finish();
    for (geom::Footprint& f : out_.footprints) f.bottom = lowest_;
    return std::move(out_);
  }

 private:
  double rounded_up(float height) const {
    return step_ > 0 ? std::ceil(height / step_) * step_ : static_cast<double>(height);
  }

  struct Add {
    SurfaceReader& reader;

    void operator()(const geom::CellRectangle<double>& r) const {
      const auto corner = [&](long column, long row) {
        return reader.raster_.corner(static_cast<double>(column), static_cast<double>(row));
      };
      geom::Footprint f;
      f.id = reader.out_.footprints.size();
      f.top = r.value;
      f.polygon.outer = {corner(r.first_column, r.first_row), corner(r.last_column, r.first_row),
                         corner(r.last_column, r.last_row), corner(r.first_column, r.last_row)};
      reader.out_.footprints.push_back(std::move(f));
    }
  };

  const Raster& raster_;
  const std::string& name_;
  double step_;
  double lowest_ = std::numeric_limits<double>::infinity();
  Source out_;
};

}  // namespace

bool is_raster(const std::string& path) {
  const Dataset dataset = open(path, GDAL_OF_RASTER);
  return dataset && dataset->GetRasterCount() > 0;
}

Source read_raster(const std::string& path, const std::string& name, const ReadOptions& options) {
  const Raster raster = open_raster(path, name);
  return SurfaceReader(raster, name, options).read();
}

Terrain::Terrain(const std::string& path, const std::string& name) : name_(name) {
  const Raster raster = open_raster(path, name);
  crs_ = raster.crs;
  std::copy(raster.transform, raster.transform + 6, transform_);
  width_ = raster.width;
  height_ = raster.height;
  cells_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  for (int row = 0; row < height_; ++row) {
    raster.read_row(row, name, cells_.data() + static_cast<std::ptrdiff_t>(row) * width_);
  }
}

std::optional<Terrain::Range> Terrain::range(const geom::Vec2& low, const geom::Vec2& high,
                                             const std::string& crs) const {
  std::unique_ptr<OGRCoordinateTransformation> to_raster;
  if (!crs.empty() && !crs_.empty()) {
    const OGRSpatialReference from = reference(crs, name_);
    const OGRSpatialReference to = reference(crs_, name_);
    to_raster.reset(OGRCreateCoordinateTransformation(&from, &to));
    if (!to_raster) throw geom::InputError(name_, "PROJ cannot reach the terrain's coordinates");
  }
  double inverse[6];
  double forward[6];
  std::copy(transform_, transform_ + 6, forward);
  if (!GDALInvGeoTransform(forward, inverse)) {
    throw geom::InputError(name_, "expected a raster whose cells have an area");
  }
  double c0 = std::numeric_limits<double>::infinity();
  double c1 = -c0;
  double r0 = c0;
  double r1 = -c0;
  for (geom::Vec2 p : {low, high, geom::Vec2(low.x(), high.y()), geom::Vec2(high.x(), low.y())}) {
    if (to_raster && !to_raster->Transform(1, &p.x(), &p.y())) return std::nullopt;
    const double column = inverse[0] + p.x() * inverse[1] + p.y() * inverse[2];
    const double row = inverse[3] + p.x() * inverse[4] + p.y() * inverse[5];
    c0 = std::min(c0, column);
    c1 = std::max(c1, column);
    r0 = std::min(r0, row);
    r1 = std::max(r1, row);
  }
  // One more cell all around: a straight side may bulge in the raster's coordinates.
  const auto clamped = [](double v, int n) {
    return static_cast<int>(std::clamp(v, 0.0, n - 1.0));
  };
  if (c1 < -1 || r1 < -1 || c0 > width_ || r0 > height_) return std::nullopt;
  std::optional<Range> out;
  for (int row = clamped(r0 - 1, height_); row <= clamped(r1 + 1, height_); ++row) {
    for (int column = clamped(c0 - 1, width_); column <= clamped(c1 + 1, width_); ++column) {
      const double cell = cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                                 static_cast<std::size_t>(column)];
      if (std::isnan(cell)) continue;
      out = out ? Range{std::min(out->low, cell), std::max(out->high, cell)} : Range{cell, cell};
    }
  }
  return out;
}

}  // namespace footprints
