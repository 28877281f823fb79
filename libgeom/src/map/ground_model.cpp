#include "geom/map/ground_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <ostream>
#include <tuple>

#include "base/unchanged_file.h"
#include "geom/archive/array_archive.h"
#include "geom/base/error.h"
#include "geom/base/rounding.h"
#include "geom/text/json_fields.h"
#include "geom/text/json_line.h"

namespace geom {
namespace {

constexpr int kVersion = 1;
constexpr double kMostCells = 2.5e8;
constexpr double kHair = 1e-12;  // of a cell and of its number: more than dividing rounds by

GroundGridSpec spec_of(const JsonFields& meta) {
  if (meta.text("format", "") != "skyway-ground" ||
      meta.number("version").value_or(0) != kVersion) {
    meta.refuse({.expected = "the ground of a map (format \"skyway-ground\", version 1)",
                 .found = "format " + in_quotes(meta.text("format", "none")),
                 .advice = "skyway-footprints --ground-of makes one of a height model"});
  }
  GroundGridSpec spec;
  spec.frame.axes = meta.word("frame", kAxesWords, Axes::enu);
  if (meta.has("origin")) {
    const Vec3 origin = meta.point("origin");
    spec.frame.origin = GeodeticOrigin{origin[0], origin[1], origin[2]};
  }
  spec.frame.crs = meta.text("crs", "");
  spec.corner = meta.point("corner").head<2>();
  spec.cell = meta.number("cell").value_or(0);
  spec.error = meta.number("error").value_or(-1);
  const double columns = meta.number("columns").value_or(0);
  const double rows = meta.number("rows").value_or(0);
  if (!(spec.cell > 0 && spec.error >= 0 && columns >= 1 && rows >= 1 &&
        columns * rows <= kMostCells) ||
      columns != std::floor(columns) || rows != std::floor(rows)) {
    meta.refuse({.expected = "cells with a size, an error of at least 0 and whole counts",
                 .found = "others"});
  }
  spec.columns = static_cast<std::size_t>(columns);
  spec.rows = static_cast<std::size_t>(rows);
  spec.source = meta.text("source", "");
  spec.hash = meta.text("hash", "");
  return spec;
}

// What a fault of the numbers is, or nothing.
std::optional<Fault> numbers_fault(std::span<const double> low, std::span<const double> high,
                                   std::size_t cells) {
  if (low.size() != cells || high.size() != cells) {
    return Fault{.expected = fmt::format("{} cells", cells),
                 .found = fmt::format("{} and {}", low.size(), high.size())};
  }
  for (std::size_t i = 0; i < cells; ++i) {
    const bool hole = std::isnan(low[i]) && std::isnan(high[i]);
    const bool height = low[i] <= high[i] && std::abs(low[i]) <= kLargestCoordinate &&
                        std::abs(high[i]) <= kLargestCoordinate;
    if (!hole && !height) {
      return Fault{.item = fmt::format("cell {}", i),
                   .expected = "two heights, the lower first, or none",
                   .found = fmt::format("{} and {}", low[i], high[i])};
    }
  }
  return std::nullopt;
}

}  // namespace

GroundModel GroundModel::flat(double z) { return GroundModel(z); }

GroundModel::GroundModel(GroundGridSpec spec, std::vector<double> low, std::vector<double> high)
    : spec_(std::move(spec)), low_(std::move(low)), high_(std::move(high)) {
  assert(!numbers_fault(low_, high_, spec_.columns * spec_.rows));
}

long GroundModel::first_cell(double at, int axis) const {
  const double cells = (at - spec_.corner[axis]) / spec_.cell;
  return static_cast<long>(
      std::clamp(std::floor(cells + kHair * (1 + std::abs(cells))), -1e9, 1e9));
}

long GroundModel::last_cell(double at, int axis) const {
  const double cells = (at - spec_.corner[axis]) / spec_.cell;
  const double after = std::ceil(cells - kHair * (1 + std::abs(cells)));
  return static_cast<long>(std::clamp(after - 1, -1e9, 1e9));
}

std::optional<std::pair<Rectangle, Rectangle>> GroundModel::cut(const Rectangle& region) const {
  if (flat_) return std::nullopt;
  const Vec2 size = region.max - region.min;
  const int longer = size.x() >= size.y() ? 0 : 1;
  for (const int axis : {longer, 1 - longer}) {
    const long middle = last_cell((region.min[axis] + region.max[axis]) / 2, axis);
    for (const double at : {face(middle, axis), face(middle + 1, axis)}) {
      if (!(region.min[axis] < at && at < region.max[axis])) continue;
      std::pair<Rectangle, Rectangle> out{region, region};
      out.first.max[axis] = out.second.min[axis] = at;
      return out;
    }
  }
  return std::nullopt;
}

GroundRange GroundModel::range(const Rectangle& region) const {
  if (flat_) return {*flat_, *flat_, true, true};
  const auto columns = static_cast<long>(spec_.columns);
  const auto rows = static_cast<long>(spec_.rows);
  const long i0 = first_cell(region.min.x(), 0);
  const long j0 = first_cell(region.min.y(), 1);
  const long i1 = std::max(i0, last_cell(region.max.x(), 0));
  const long j1 = std::max(j0, last_cell(region.max.y(), 1));
  GroundRange out;
  out.all_known = i0 >= 0 && j0 >= 0 && i1 < columns && j1 < rows;
  for (long j = std::max(0L, j0); j <= std::min(rows - 1, j1); ++j) {
    for (long i = std::max(0L, i0); i <= std::min(columns - 1, i1); ++i) {
      const auto at = static_cast<std::size_t>(j * columns + i);
      if (std::isnan(low_[at])) {
        out.all_known = false;
        continue;
      }
      out.low = out.any_known ? std::min(out.low, low_[at]) : low_[at];
      out.high = out.any_known ? std::max(out.high, high_[at]) : high_[at];
      out.any_known = true;
    }
  }
  out.low = add_down(out.low, -spec_.error);
  out.high = add_up(out.high, spec_.error);
  return out;
}

void write_ground(std::ostream& out, const GroundModel& ground) {
  const GroundGridSpec& spec = ground.spec();
  JsonLine meta;
  meta.add("format", "skyway-ground").add("version", kVersion);
  meta.add("frame", name(spec.frame.axes));
  if (const auto& origin = spec.frame.origin) {
    meta.add("origin", std::tuple(origin->latitude, origin->longitude, origin->height));
  }
  meta.add("crs", spec.frame.crs);
  meta.add("corner", std::tuple(spec.corner.x(), spec.corner.y(), 0.0)).add("cell", spec.cell);
  meta.add("columns", spec.columns).add("rows", spec.rows).add("error", spec.error);
  meta.add("source", spec.source).add("hash", spec.hash);
  const std::vector arrays = {named_array<double>("low", ground.lows(), spec.columns),
                              named_array<double>("high", ground.highs(), spec.columns)};
  write_array_archive(out, meta.line(), arrays);
}

GroundModel read_ground(const std::string& path) {
  const ArrayArchive archive = ArrayArchive::map(path);
  archive.verify();
  GroundGridSpec spec = spec_of({archive.meta(), archive.name() + ": meta.json", 0});
  const std::span<const double> low = archive.array<double>("low", spec.columns);
  const std::span<const double> high = archive.array<double>("high", spec.columns);
  if (const auto fault = numbers_fault(low, high, spec.columns * spec.rows)) {
    throw InputError(archive.name(), *fault);
  }
  GroundModel ground{std::move(spec), {low.begin(), low.end()}, {high.begin(), high.end()}};
  require_unchanged_at(archive.meta().data());  // since it was verified
  return ground;
}

void require_same_frame(const GroundModel& ground, const Frame& frame, const std::string& source) {
  if (ground.is_flat() || ground.spec().frame == frame) return;
  throw InputError(source, {.expected = "the ground of this map (same axes, origin and system)",
                            .found = "that of another",
                            .advice = "make it with skyway-footprints --ground-of this map"});
}

}  // namespace geom
