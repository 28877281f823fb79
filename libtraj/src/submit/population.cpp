#include "traj/submit/population.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <istream>
#include <limits>
#include <numeric>
#include <set>

#include "geom/base/error.h"
#include "geom/map/geodetic_outline.h"
#include "geom/shape/convex_outline.h"
#include "geom/text/csv_field.h"
#include "geom/text/number.h"

namespace traj {
namespace {

using geom::Vec2;

constexpr std::string_view kHeader = "row,column,people,lon,lat,lon,lat,lon,lat,lon,lat";
constexpr std::size_t kFields = 11;
constexpr double kBend = 2e-3;     // of a cell's longest side: twice what its edges may bend
constexpr double kReserve = 1e-3;  // m
constexpr double kSame = 1e-9;     // degrees, a tenth of a millimetre

class Line {
 public:
  Line(std::string_view text, std::string_view source, std::size_t number)
      : source_(source), number_(number) {
    for (std::size_t at = 0; at <= text.size();) {
      const std::size_t comma = std::min(text.find(',', at), text.size());
      fields_.push_back(text.substr(at, comma - at));
      at = comma + 1;
    }
    if (fields_.size() != kFields) {
      refuse({.expected = "11 fields", .found = fmt::to_string(fields_.size())});
    }
  }

  bool empty(std::size_t i) const { return fields_[i].empty(); }

  double number(std::size_t i, double least, double most) const {
    const std::string_view field = fields_[i];
    double value = 0;
    const auto read = geom::read_number(field.data(), field.data() + field.size(), value);
    const bool whole = read.ec == std::errc() && read.ptr == field.data() + field.size();
    if (whole && value >= least && value <= most) return value;
    refuse({.key = fmt::format("field {}", i + 1),
            .expected = fmt::format("a number from {} to {}", least, most),
            .found = geom::in_quotes(fields_[i])});
  }

  std::size_t index(std::size_t i) const {
    const double value = number(i, 0, 1e9);
    if (value != std::floor(value)) {
      refuse({.key = fmt::format("field {}", i + 1),
              .expected = "a whole number",
              .found = geom::in_quotes(fields_[i])});
    }
    return static_cast<std::size_t>(value);
  }

  [[noreturn]] void refuse(geom::Fault fault) const {
    throw geom::InputError(source_, number_, std::move(fault));
  }

 private:
  std::string_view source_;
  std::size_t number_;
  std::vector<std::string_view> fields_;
};

PopulationCell cell_of(const Line& line) {
  PopulationCell out;
  out.row = line.index(0);
  out.column = line.index(1);
  if (!line.empty(2)) out.people = line.number(2, 0, 1e10);
  for (std::size_t i = 0; i < out.corners.size(); ++i) {
    out.corners[i].longitude = line.number(3 + 2 * i, -360, 360);
    out.corners[i].latitude = line.number(4 + 2 * i, -90, 90);
  }
  return out;
}

// Whether a line along an edge of `a` has all of `b` beyond it. Both are counterclockwise.
bool apart(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec2 along = a[(i + 1) % a.size()] - a[i];
    const Vec2 out(along.y(), -along.x());
    const bool beyond = std::all_of(b.begin(), b.end(), [&](const Vec2& p) {
      return out.dot(p - a[i]) > kReserve * out.norm();
    });
    if (beyond) return true;
  }
  return false;
}

// Of a convex ring, counterclockwise; also where rounding puts the place beside it.
bool holds(const std::vector<Vec2>& ring, const Vec2& place) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 along = ring[(i + 1) % ring.size()] - ring[i];
    const Vec2 out(along.y(), -along.x());
    if (out.dot(place - ring[i]) > kReserve * out.norm()) return false;
  }
  return true;
}

std::vector<Vec2> wider(const std::vector<Vec2>& ring, double by) {
  std::vector<Vec2> points;
  for (const Vec2& p : ring) {
    for (const double x : {-by, by}) {
      for (const double y : {-by, by}) points.push_back(p + Vec2(x, y));
    }
  }
  return geom::convex_outline(std::move(points));
}

// Edges that a cell does not share with the next one in its row or column.
class Border {
 public:
  explicit Border(const std::vector<PopulationCell>& cells) {
    std::size_t last_row = 0;
    for (const PopulationCell& cell : cells) {
      first_row_ = std::min(first_row_, cell.row);
      first_column_ = std::min(first_column_, cell.column);
      columns_ = std::max(columns_, cell.column + 1);
      last_row = std::max(last_row, cell.row);
    }
    columns_ -= cells.empty() ? 0 : first_column_;
    grid_.resize(cells.empty() ? 0 : (last_row - first_row_ + 1) * columns_);
    for (const PopulationCell& cell : cells) grid_[index(cell.row, cell.column)] = &cell;
  }

  bool has(const PopulationCell& cell, std::size_t edge) const {
    const std::size_t next = (edge + 1) % cell.corners.size();
    const auto shares = [&](std::size_t row, std::size_t column) {
      const std::size_t at = index(row, column);
      return at < grid_.size() && grid_[at] && is_corner(*grid_[at], cell.corners[edge]) &&
             is_corner(*grid_[at], cell.corners[next]);
    };
    const bool left = cell.column > first_column_ && shares(cell.row, cell.column - 1);
    const bool right =
        cell.column + 1 < first_column_ + columns_ && shares(cell.row, cell.column + 1);
    const bool above = cell.row > first_row_ && shares(cell.row - 1, cell.column);
    return !(left || right || above || shares(cell.row + 1, cell.column));
  }

 private:
  static bool is_corner(const PopulationCell& cell, const geom::GeodeticPlace& place) {
    return std::any_of(cell.corners.begin(), cell.corners.end(), [&](const auto& corner) {
      return std::abs(corner.latitude - place.latitude) <= kSame &&
             std::abs(corner.longitude - place.longitude) <= kSame;
    });
  }
  std::size_t index(std::size_t row, std::size_t column) const {
    return (row - first_row_) * columns_ + column - first_column_;
  }

  std::size_t first_row_ = std::numeric_limits<std::size_t>::max();
  std::size_t first_column_ = first_row_;
  std::size_t columns_ = 0;
  std::vector<const PopulationCell*> grid_;  // row by row
};

struct Reach {
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
  Vec2 high = -low;

  void add(const std::vector<Vec2>& ring) {
    for (const Vec2& p : ring) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  bool meets(const Reach& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};

}  // namespace

Population read_population(std::istream& in, std::string_view source) {
  Population out;
  std::string text;
  std::size_t number = 0;
  std::set<std::pair<std::size_t, std::size_t>> seen;
  while (std::getline(in, text)) {
    ++number;
    if (number == 1) {
      if (text != kHeader) {
        throw geom::InputError(source, 1, {.expected = std::string(kHeader), .found = text});
      }
      continue;
    }
    const Line line(text, source, number);
    out.cells.push_back(cell_of(line));
    const auto& cell = out.cells.back();
    if (!seen.insert({cell.row, cell.column}).second) {
      line.refuse({.says = fmt::format("row {}, column {} comes twice", cell.row, cell.column)});
    }
  }
  if (out.cells.empty()) {
    throw geom::InputError(source, {.expected = "cells of a population raster", .found = "none"});
  }
  const auto& first = *seen.begin();
  const auto& last = *seen.rbegin();
  const std::size_t all =
      (last.first - first.first + 1) * (last.second - std::min(first.second, last.second) + 1);
  if (last.second < first.second || all != out.cells.size()) {
    throw geom::InputError(source, {.expected = "every cell of some rows and columns, each once",
                                    .found = fmt::format("{} cells", out.cells.size())});
  }
  return out;
}

std::string population_csv(const Population& population) {
  std::string out(kHeader);
  out += '\n';
  for (const PopulationCell& cell : population.cells) {
    out += fmt::format("{},{},", cell.row, cell.column);
    if (cell.people) geom::append_number(out, *cell.people);
    for (const geom::GeodeticPlace& corner : cell.corners) {
      out += ',';
      geom::append_number(out, corner.longitude);
      out += ',';
      geom::append_number(out, corner.latitude);
    }
    out += '\n';
  }
  return out;
}

PopulationOnMap::PopulationOnMap(const Population& population, const geom::GeodeticOrigin& origin)
    : origin_(origin) {
  const geom::GeographicFrame earth(origin);
  const Border border(population.cells);
  for (const PopulationCell& cell : population.cells) {
    std::vector<Vec2> ring;
    for (const geom::GeodeticPlace& corner : cell.corners) {
      Vec2& at = ring.emplace_back();
      earth.from_geodetic(corner.latitude, corner.longitude, at.x(), at.y());
    }
    double longest = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2& next = ring[(i + 1) % ring.size()];
      const double side = (next - ring[i]).norm();
      longest = std::max(longest, side);
      if (border.has(cell, i)) border_.push_back(wider({ring[i], next}, kBend * side));
    }
    cells_.push_back({geom::convex_outline(ring), wider(ring, kBend * longest), cell.people});
  }
}

Exposed PopulationOnMap::exposed(std::span<const RiskVolume> buffers) const {
  struct Buffer {
    std::vector<Vec2> outline;
    Vec2 middle;
    Reach reach = {};
    bool held = false;  // its middle is in a cell

    bool touches(const std::vector<Vec2>& other, const Reach& at) const {
      return reach.meets(at) && !apart(outline, other) && !apart(other, outline);
    }
  };
  std::vector<Buffer> all;
  for (const RiskVolume& buffer : buffers) {
    const geom::MapOutline outline = geom::outline_on_map(
        buffer.volume.outline, origin_, geom::CircleSide::around, "a buffer", "ground risk buffer");
    const std::vector<Vec2> ring = wider(outline.ring, outline.bulge);
    const Vec2 sum = std::accumulate(ring.begin(), ring.end(), Vec2::Zero().eval());
    all.push_back({ring, sum / static_cast<double>(ring.size())});
    all.back().reach.add(ring);
  }
  Exposed out;
  for (const Cell& cell : cells_) {
    Reach at;
    at.add(cell.outline);
    bool touched = false;
    for (Buffer& one : all) {
      if (!one.reach.meets(at)) continue;
      one.held = one.held || holds(cell.ring, one.middle);
      touched = touched || one.touches(cell.outline, at);
    }
    if (!touched) continue;
    out.people += cell.people.value_or(0);
    out.unknown += !cell.people;
  }
  // A buffer that begins in a cell and meets no edge of the border is in cells all over.
  for (const std::vector<Vec2>& edge : border_) {
    Reach at;
    at.add(edge);
    for (const Buffer& one : all) out.inside = out.inside && !one.touches(edge, at);
  }
  for (const Buffer& one : all) out.inside = out.inside && one.held;
  return out;
}

}  // namespace traj
