#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <span>

#include "base/watched_memory.h"
#include "gdal_cells.h"
#include "gdal_content.h"
#include "gdal_handles.h"
#include "gdal_reference.h"
#include "gdal_whole.h"
#include "gdal_whole_raster.h"
#include "geom/base/text_stream.h"
#include "geom/gis/footprint_source.h"
#include "shape/row_merge.h"
#include "shape/skyline_merge.h"

namespace geom::gis {
namespace {

constexpr double kMostCells = 2e9;
constexpr double kMostTerrain = 2.5e8;  // cells, which are held in memory
constexpr double kHighest = 1e4;        // metres
constexpr double kUsualNone = -9999;    // what many write where they have no height
constexpr double kShortNone = -999;     // what others do, unless they measured a deep sea

[[noreturn]] void refuse_none(double none, int row, int column, const std::string& name) {
  throw InputError(
      name,
      {.item = fmt::format("row {}, column {}", row, column),
       .expected = "a height",
       .found = fmt::format("{}, and the file does not say that this stands for none", none),
       .advice = fmt::format("say it, for example with `gdal_translate -a_nodata {}`", none)});
}

// The floor of a sea has other cells about as deep in a row.
bool is_sea_floor(std::span<const double> row) {
  return std::any_of(row.begin(), row.end(), [](double cell) {
    return cell != kShortNone && std::abs(cell - kShortNone) < 100;
  });
}

struct Raster {
  DatasetHandle dataset;
  std::optional<RasterCells> cells;
  CellGrid grid;
  std::optional<ProjReference> crs;
  int width = 0;
  int height = 0;
  double metres = 1;  // per unit of the numbers

  // A row's heights in metres; NaN where there is no data.
  void read_row(int row, const std::string& name, double* out) const {
    if (!cells->read(0, row, width, 1, out)) {
      throw InputError(name, {.says = fmt::format("row {} of heights cannot be read (GDAL: {})",
                                                  row, gdal().last_error()),
                              .advice = "the file is damaged or cut, get it again"});
    }
    const std::span<const double> all(out, static_cast<std::size_t>(width));
    const auto none = std::find(all.begin(), all.end(), kShortNone);
    if (none != all.end() && !is_sea_floor(all)) {
      refuse_none(kShortNone, row, static_cast<int>(none - all.begin()), name);
    }
    for (int i = 0; i < width; ++i) {
      if (out[i] == kUsualNone) refuse_none(kUsualNone, row, i, name);
      out[i] *= metres;
      if (out[i] > kHighest) {
        throw InputError(name, {.item = fmt::format("row {}, column {}", row, i),
                                .expected = fmt::format("a height of at most {} m", kHighest),
                                .found = fmt::to_string(out[i]),
                                .advice = "say which value stands for none (`gdal_translate "
                                          "-a_nodata`), or what the unit is (--height-units)"});
      }
      // What is said to lie deeper than any place on Earth is a value for none.
      if (out[i] < -kHighest) out[i] = std::numeric_limits<double>::quiet_NaN();
    }
  }
};

// What says in which unit heights are, and is not obeyed by GDAL: "Zunits FEET" in the .prj of a
// grid, "ZUNITS FEET" in the .hdr of another.
void require_metres_beside(const DatasetHandle& dataset, const std::string& path,
                           const std::string& name) {
  const std::string_view driver = gdal().driver_name(gdal().driver_of(dataset.get()));
  if (driver != "AAIGrid" && driver != "EHdr") return;
  for (const char* ending : {"prj", "PRJ", "hdr", "HDR"}) {
    const std::string beside = gdal().with_extension(path.c_str(), ending);
    VSIStatBufL about;
    if (gdal().stat(beside.c_str(), &about) != 0) continue;
    TextInput words(content_of(beside, name));
    for (std::string word; words >> word;) {
      if (!EQUAL(word.c_str(), "zunits") || !(words >> word)) continue;
      const char* const plain[] = {"no",     "none", "meter", "meters", "metre",
                                   "metres", "m",    "1",     "1.0"};
      if (std::any_of(std::begin(plain), std::end(plain),
                      [&](const char* unit) { return EQUAL(word.c_str(), unit); })) {
        continue;
      }
      throw InputError(name, {.expected = "heights in metres",
                              .found = fmt::format("\"Zunits {}\" in its .{}", word, ending),
                              .advice = "give --height-units m, ft or us-ft"});
    }
  }
}

double metres_per(const std::string& unit, const std::string& name) {
  static const std::map<std::string, double> known = {{"m", 1},
                                                      {"metre", 1},
                                                      {"meter", 1},
                                                      {"metres", 1},
                                                      {"meters", 1},
                                                      {"ft", 0.3048},
                                                      {"foot", 0.3048},
                                                      {"feet", 0.3048},
                                                      {"cm", 0.01},
                                                      {"dm", 0.1},
                                                      {"us-ft", 1200.0 / 3937},
                                                      {"ftUS", 1200.0 / 3937},
                                                      {"us survey feet", 1200.0 / 3937},
                                                      {"US survey foot", 1200.0 / 3937}};
  const auto at = std::find_if(known.begin(), known.end(), [&](const auto& one) {
    return EQUAL(one.first.c_str(), unit.c_str());
  });
  if (at == known.end()) {
    throw InputError(name, {.expected = "heights in metres or feet",
                            .found = fmt::format("the unit \"{}\"", unit)});
  }
  return at->second;
}

// What the band says; else as other heights of its CRS.
double metres_per_unit(GDALRasterBandH band, const std::optional<ProjReference>& crs,
                       const std::string& name, const ReadOptions& options) {
  if (crs) require_upward(*crs, name);
  const std::string unit = gdal().raster_unit(band);
  if (unit.empty()) {
    const auto metres = height_unit(crs, name, options);
    if (!metres) refuse_heights(name, *crs);
    return *metres;
  }
  const double metres = metres_per(unit, name);
  if (options.height_unit && std::abs(*options.height_unit - metres) > 1e-9) {
    throw InputError(
        name,
        {.says = fmt::format("its heights are in \"{}\", but --height-units says otherwise", unit),
         .advice = "leave the option out"});
  }
  return metres;
}

Raster open_raster(const std::string& path, const std::string& name, const ReadOptions& options) {
  Raster raster;
  raster.dataset = opened(path, GDAL_OF_RASTER);
  const GDALDatasetH dataset = raster.dataset.get();
  if (!dataset || gdal().raster_count(dataset) < 1) {
    throw InputError(name, {.expected = "a raster of heights, as a GeoTIFF",
                            .found = "a file that GDAL cannot open as one"});
  }
  require_whole_raster(raster.dataset, path, name);
  if (const int bands = number_bands(raster.dataset); bands != 1) {
    const int all = gdal().raster_count(dataset);
    throw InputError(name,
                     {.expected = "one band of heights",
                      .found = fmt::to_string(bands),
                      .advice = fmt::format(
                          "choose one, for example with `gdal_translate -b 1{} in.tif out.tif`",
                          all > bands ? fmt::format(" -mask {}", all) : "")});
  }
  raster.cells.emplace(raster.dataset, path, name);
  raster.width = gdal().raster_width(dataset);
  raster.height = gdal().raster_height(dataset);
  if (static_cast<double>(raster.width) * raster.height > kMostCells) {
    throw InputError(name, {.expected = "at most 2e9 cells",
                            .found = fmt::format("{} x {}", raster.width, raster.height)});
  }
  if (gdal().geo_transform(dataset, raster.grid.transform) != CE_None) {
    throw InputError(name,
                     {.expected = "a raster that says where on Earth its cells are",
                      .found = "one that does not",
                      .advice = "give it a place, for example with `gdal_translate -a_ullr`"});
  }
  require_known_raster_reference(raster.dataset, path, name);
  raster.crs = reference_of(gdal().spatial_reference(dataset), name);
  if (!options.height_unit) require_metres_beside(raster.dataset, path, name);
  raster.metres = metres_per_unit(raster.cells->band(), raster.crs, name, options);
  return raster;
}

class SurfaceReader {
 public:
  SurfaceReader(const Raster& raster, const std::string& name, const ReadOptions& options)
      : raster_(raster), name_(name), options_(options) {}

  // Where neither side of two cells by two leans by more than the slack, rectangles are as large as
  // one box can be; else cover() makes several of each.
  Source read() {
    out_.crs = raster_.crs;
    if (raster_.crs) out_.grid = raster_.grid;
    const CellLean lean =
        lean_of(raster_.grid, raster_.width, raster_.height, raster_.crs, options_.origin);
    const long columns = within_slack(lean.column);
    const long rows = within_slack(lean.row);
    if (std::min(columns, rows) >= 2) {
      SkylineMerge<Add> merge(Add{*this}, columns, rows);
      for_each_row([&](int, std::span<const double> cells) { merge.add_row(cells); });
      merge.finish();
    } else {
      RowMerge<double, Add> merge(Add{*this});
      for_each_row([&](int row, std::span<const double> cells) {
        for (std::size_t i = 0; i < cells.size(); ++i) {
          if (!std::isnan(cells[i])) merge.add(row, static_cast<long>(i), cells[i]);
        }
      });
      merge.finish();
    }
    for (Footprint& f : out_.footprints) {
      f.bottom = lowest_;
      f.ground = true;
    }
    return std::move(out_);
  }

 private:
  // How many cells in line lean by no more than most of the slack.
  long within_slack(double lean) const {
    constexpr double kMost = 1e6;
    return static_cast<long>(std::min(0.9 * options_.slack / lean, kMost));
  }

  // Calls f(row, heights rounded up).
  template <class F>
  void for_each_row(const F& f) {
    std::vector<double> cells(static_cast<std::size_t>(raster_.width));
    std::size_t known = 0;
    for (int row = 0; row < raster_.height; ++row) {
      raster_.read_row(row, name_, cells.data());
      for (double& cell : cells) {
        if (std::isnan(cell)) continue;
        ++known;
        lowest_ = std::min(lowest_, cell);
        cell = rounded_up(cell);
      }
      f(row, cells);
      if (row == raster_.height / 8) reserve();
    }
    const std::size_t all = cells.size() * static_cast<std::size_t>(raster_.height);
    if (known > 0) out_.counts["cells"] = known;
    if (known < all) out_.counts["cells_without_data"] = all - known;
  }

  // An eighth of the rows is read. The others may have as much each, and a little more.
  void reserve() {
    out_.footprints.reserve(9 * out_.footprints.size());
    if (out_.grid) out_.grid->of.reserve(9 * out_.grid->of.size());
  }

  double rounded_up(double height) const {
    const double step = options_.height_step;
    if (step == 0) return height;
    double steps = std::ceil(height / step);
    while (steps * step < height) ++steps;  // the division may round down
    return steps * step;
  }

  struct Add {
    SurfaceReader& reader;

    void operator()(const CellRectangle<double>& r) const {
      const CellGrid& grid = reader.raster_.grid;
      const CellGrid::Cells cells{static_cast<int>(r.first_column), static_cast<int>(r.last_column),
                                  static_cast<int>(r.first_row), static_cast<int>(r.last_row)};
      Footprint f;
      f.id = reader.out_.footprints.size();
      f.top = r.value;
      f.polygon.outer = {grid.corner(cells.first_column, cells.first_row),
                         grid.corner(cells.last_column, cells.first_row),
                         grid.corner(cells.last_column, cells.last_row),
                         grid.corner(cells.first_column, cells.last_row)};
      if (reader.out_.grid) reader.out_.grid->of.push_back(cells);
      reader.out_.footprints.push_back(std::move(f));
    }
  };

  const Raster& raster_;
  const std::string& name_;
  const ReadOptions& options_;
  double lowest_ = std::numeric_limits<double>::infinity();
  Source out_;
};

// Places along the sides of a rectangle, which bend in other coordinates.
std::vector<Vec2> around_rectangle(const Vec2& low, const Vec2& high) {
  constexpr int kSteps = 8;  // a side
  std::vector<Vec2> out;
  for (int i = 0; i <= kSteps; ++i) {
    const Vec2 p = low + (high - low) * i / kSteps;
    for (const double y : {low.y(), high.y()}) out.emplace_back(p.x(), y);
    for (const double x : {low.x(), high.x()}) out.emplace_back(x, p.y());
  }
  return out;
}

// Columns or rows, the last one excluded.
struct Span {
  int first;
  int last;
};

// Those of `n` that an interval reaches into; those below 0 and from `n` on are outside. What lies
// along the edge between two, as a wall may, is in either of them.
std::vector<Span> touched(double low, double high, int n) {
  constexpr double kAside = 0.01;  // cells: far more than numbers round
  const auto bounded = [&](double v) { return static_cast<int>(std::clamp(v, -2.0, n + 2.0)); };
  const int first = bounded(std::floor(low + kAside));
  const int last = bounded(std::ceil(high - kAside));
  if (first < last) return {{first, last}};
  return {{first - 1, first}, {first, first + 1}};
}

// LERC may have been told to allow an error, which GDAL does not tell.
bool may_be_inexact(const DatasetHandle& dataset) {
  char** const entries = gdal().metadata(dataset.get(), "IMAGE_STRUCTURE");
  for (char** entry = entries; entry && *entry; ++entry) {
    if (std::string_view(*entry).starts_with("COMPRESSION=LERC")) return true;
  }
  return false;
}

}  // namespace

bool is_raster(const std::string& path) {
  const DatasetHandle dataset = opened(path, GDAL_OF_RASTER);
  if (!dataset || gdal().raster_count(dataset.get()) == 0) return false;
  require_no_layers(dataset, path);
  return true;
}

Source read_raster(const std::string& path, const std::string& name, const ReadOptions& options) {
  const Raster raster = open_raster(path, name, options);
  Source source = SurfaceReader(raster, name, options).read();
  source.beside = files_beside(raster.dataset, path);
  if (may_be_inexact(raster.dataset)) {
    source.warnings.push_back(
        "its compression (LERC) may have changed heights by as much as the MAX_Z_ERROR of whoever "
        "wrote it, which the file does not tell: ask for that, and keep as much room above");
  }
  return source;
}

Terrain::Terrain(const std::string& path, const std::string& name, const ReadOptions& options)
    : name_(name) {
  const WatchedMemory memory;
  const Raster raster = open_raster(path, name, options);
  if (static_cast<double>(raster.width) * raster.height > kMostTerrain) {
    throw InputError(name, {.expected = fmt::format("a terrain of at most {} cells", kMostTerrain),
                            .found = fmt::format("{} x {}", raster.width, raster.height),
                            .advice = "cut it to the city, for example with `gdalwarp -te`"});
  }
  crs_ = raster.crs;
  std::copy(raster.grid.transform, raster.grid.transform + 6, transform_);
  width_ = raster.width;
  height_ = raster.height;
  cells_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  for (int row = 0; row < height_; ++row) {
    raster.read_row(row, name, cells_.data() + static_cast<std::ptrdiff_t>(row) * width_);
  }
  memory.require_enough();
}

double Terrain::at(int column, int row) const {
  return cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                static_cast<std::size_t>(column)];
}

std::optional<Terrain::Range> Terrain::surface(std::span<const Vec2> around) const {
  constexpr double kAside = 0.01;  // cells: far more than straight sides bulge and numbers round
  double inverse[6];
  double forward[6];
  std::copy(transform_, transform_ + 6, forward);
  if (!gdal().invert_geo_transform(forward, inverse)) return std::nullopt;
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 high = -low;
  for (const Vec2& p : around) {
    const Vec2 cell(inverse[0] + p.x() * inverse[1] + p.y() * inverse[2],
                    inverse[3] + p.x() * inverse[4] + p.y() * inverse[5]);
    if (!cell.allFinite()) return std::nullopt;
    low = low.cwiseMin(cell);
    high = high.cwiseMax(cell);
  }
  const Vec2 size(width_, height_);
  if (!(low.minCoeff() >= -kAside && (size - high).minCoeff() >= -kAside)) return std::nullopt;
  const auto first = [](double v) {
    return std::max(0, static_cast<int>(std::floor(v - 0.5 - kAside)));
  };
  const auto last = [](double v, int n) {
    return std::min(n - 1, static_cast<int>(std::floor(v - 0.5 + kAside)) + 1);
  };
  std::optional<Range> out;
  for (int row = first(low.y()); row <= last(high.y(), height_); ++row) {
    for (int column = first(low.x()); column <= last(high.x(), width_); ++column) {
      const double cell = at(column, row);
      if (std::isnan(cell)) return std::nullopt;
      out = out ? Range{std::min(out->low, cell), std::max(out->high, cell)} : Range{cell, cell};
    }
  }
  return out;
}

std::optional<Terrain::Range> Terrain::range(const Vec2& low, const Vec2& high,
                                             const std::optional<ProjWay>& way) const {
  double inverse[6];
  double forward[6];
  std::copy(transform_, transform_ + 6, forward);
  if (!gdal().invert_geo_transform(forward, inverse)) {
    throw InputError(name_,
                     {.expected = "cells with an area", .found = "a geotransform that has none"});
  }
  Vec2 first = Vec2::Constant(std::numeric_limits<double>::infinity());  // column, row
  Vec2 last = -first;
  std::vector<Vec2> around = around_rectangle(low, high);
  if (way) way->back(around);
  for (const Vec2& p : around) {
    const Vec2 cell(inverse[0] + p.x() * inverse[1] + p.y() * inverse[2],
                    inverse[3] + p.x() * inverse[4] + p.y() * inverse[5]);
    if (!cell.allFinite()) return std::nullopt;
    first = first.cwiseMin(cell);
    last = last.cwiseMax(cell);
  }
  return over_cells(first, last);
}

bool Terrain::known(const Cells& cells) const {
  if (cells.first_row < 0 || cells.first_column < 0 || cells.last_row > height_ ||
      cells.last_column > width_) {
    return false;
  }
  for (int row = cells.first_row; row < cells.last_row; ++row) {
    for (int column = cells.first_column; column < cells.last_column; ++column) {
      if (std::isnan(at(column, row))) return false;
    }
  }
  return true;
}

std::optional<Terrain::Range> Terrain::over_cells(const Vec2& low, const Vec2& high) const {
  const std::vector<Span> columns = touched(low.x(), high.x(), width_);
  const std::vector<Span> rows = touched(low.y(), high.y(), height_);
  std::optional<Range> out;
  // One more cell all around: slopes between the middles of cells reach into the rectangle.
  const int last_row = std::min(height_, rows.back().last + 1);
  const int last_column = std::min(width_, columns.back().last + 1);
  for (int row = std::max(0, rows.front().first - 1); row < last_row; ++row) {
    for (int column = std::max(0, columns.front().first - 1); column < last_column; ++column) {
      const double cell = at(column, row);
      if (std::isnan(cell)) continue;
      out = out ? Range{std::min(out->low, cell), std::max(out->high, cell)} : Range{cell, cell};
    }
  }
  if (!out) return out;
  out->whole = false;
  for (const Span& column : columns) {
    for (const Span& row : rows) {
      out->whole |= known({column.first, column.last, row.first, row.last});
    }
  }
  return out;
}

}  // namespace geom::gis
