#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "geom/base/error.h"
#include "geom/gis/footprint_source.h"
#include "geom/map/geographic_frame.h"
#include "required_reference.h"

namespace geom::gis {
namespace {

// The middle of all corners, and the largest extent of one footprint.
struct Layout {
  Vec2 low;
  Vec2 high;
  double largest = 0;

  // `turn`: what is added to longitudes below 0; else 0.
  explicit Layout(const std::vector<Footprint>& footprints, double turn = 0)
      : low(east(footprints.front().polygon.outer.front(), turn)), high(low) {
    for (const Footprint& f : footprints) {
      Vec2 least = east(f.polygon.outer.front(), turn);
      Vec2 most = least;
      for (const Vec2& corner : f.polygon.outer) {
        const Vec2 p = east(corner, turn);
        least = least.cwiseMin(p);
        most = most.cwiseMax(p);
      }
      low = low.cwiseMin(least);
      high = high.cwiseMax(most);
      largest = std::max(largest, (most - least).maxCoeff());
    }
  }

 private:
  static Vec2 east(const Vec2& p, double turn) { return {p.x() < 0 ? p.x() + turn : p.x(), p.y()}; }
};

// Numbers in the range of degrees, and not one footprint as large as a tenth of one: as metres that
// would be a city of crumbs.
void require_metres(const Layout& layout, const std::string& name) {
  const bool degrees = layout.low.x() >= -180 && layout.high.x() <= 180 && layout.low.y() >= -180 &&
                       layout.high.y() <= 180 && layout.largest < 0.1;
  if (!degrees) return;
  throw InputError(
      name,
      {.says = fmt::format("the file names no coordinate reference system, and its numbers look "
                           "like degrees: [{}, {}] to [{}, {}]; name the system, for example with "
                           "`ogr2ogr -a_srs EPSG:4326`, or say that they are metres with --metres",
                           layout.low.x(), layout.low.y(), layout.high.x(), layout.high.y())});
}

constexpr double kDegree = std::numbers::pi / 180;

double kilometres(const Vec2& a, const Vec2& b) {  // longitude, latitude
  const double h = std::pow(std::sin((b.y() - a.y()) * kDegree / 2), 2) +
                   std::cos(a.y() * kDegree) * std::cos(b.y() * kDegree) *
                       std::pow(std::sin((b.x() - a.x()) * kDegree / 2), 2);
  return 2 * 6371 * std::asin(std::sqrt(std::min(1.0, h)));
}

// `at` and `middle`: longitude, latitude.
void require_near(const Vec2& at, const Vec2& middle, const std::string& name,
                  Source::Warnings& warnings) {
  constexpr double kFar = 200;      // km
  constexpr double kTooFar = 2000;  // where a plane about the origin means nothing any more
  const double away = kilometres(at, middle);
  if (away < kFar) return;
  const bool swapped = std::abs(at.x()) <= 90 && kilometres({at.y(), at.x()}, middle) < kFar;
  const Fault fault{
      .says =
          fmt::format("the origin {},{} is {:.0f} km from the data, which lie about {:.4f},{:.4f}",
                      at.y(), at.x(), away, middle.y(), middle.x()),
      .advice = swapped ? "give the latitude first, then the longitude" : ""};
  if (swapped || away > kTooFar) throw InputError(name, fault);
  warnings.push_back(sentence(fault));
}

// That of the options (latitude, longitude), or a decimetre from the middle (longitude, latitude).
GeodeticOrigin origin_at(const Vec2& middle, const std::optional<Vec2>& chosen) {
  return chosen ? GeodeticOrigin{chosen->x(), chosen->y(), 0} : tidy_origin(middle, 1e6);
}

// Points, each but once; neighbours in a grid share theirs.
struct DistinctPoints {
  std::vector<Vec2> points;
  std::vector<std::uint32_t> which;  // of `points`, for each that was given

  explicit DistinctPoints(const std::vector<Vec2>& given) {
    std::vector<std::uint32_t> known(std::bit_ceil(2 * given.size() + 1), kNone);
    which.reserve(given.size());
    for (const Vec2& p : given) {
      std::size_t at = hash(p) & (known.size() - 1);
      while (known[at] != kNone && !same(points[known[at]], p)) at = (at + 1) & (known.size() - 1);
      if (known[at] == kNone) {
        known[at] = static_cast<std::uint32_t>(points.size());
        points.push_back(p);
      }
      which.push_back(known[at]);
    }
  }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  static std::uint64_t bits(double v) { return std::bit_cast<std::uint64_t>(v); }
  static bool same(const Vec2& a, const Vec2& b) {
    return bits(a.x()) == bits(b.x()) && bits(a.y()) == bits(b.y());
  }
  static std::size_t hash(const Vec2& p) {
    const std::uint64_t mixed =
        (bits(p.x()) * 0x9E3779B97F4A7C15 ^ bits(p.y())) * 0xD6E8FEB86659FD93;
    return mixed >> 24;
  }
};

}  // namespace

Projector::Projector(Source& source, const std::string& name, const std::optional<Vec2>& origin,
                     bool metres)
    : name_(name) {
  Layout layout(source.footprints);
  if (!source.crs) {
    if (!metres) require_metres(layout, name);
    if (origin) frame_.origin = GeodeticOrigin{origin->x(), origin->y(), 0};
    return;
  }
  const ProjReference& from = *source.crs;
  if (from.is_geographic()) {
    turn_ = 2 * std::numbers::pi / from.unit().value_or(kDegree);
    // On both sides of the antimeridian: its middle is there, and not on the other side of Earth.
    if (layout.high.x() - layout.low.x() > turn_ / 2) layout = Layout(source.footprints, turn_);
  }
  auto middle =
      required_way(ProjWay::to_places(from), from, name).place_of(0.5 * (layout.low + layout.high));
  if (!middle || std::abs(middle->y()) > 90) {
    throw InputError(
        name,
        {.says = fmt::format(
             "PROJ cannot tell where on Earth the coordinates [{}, {}] to [{}, {}] are in \"{}\"",
             layout.low.x(), layout.low.y(), layout.high.x(), layout.high.y(),
             from.told().crs.substr(0, 60)),
         .advice = "is that the right coordinate reference system?"});
  }
  if (middle->x() > 180) middle->x() -= 360;
  frame_.origin = origin_at(*middle, origin);
  if (origin) require_near({origin->y(), origin->x()}, *middle, name, source.warnings);
  way_ = required_way(ProjWay::to_plane(from, *frame_.origin), from, name);
  frame_.crs = plane_about(*frame_.origin);
}

void Projector::convert(std::vector<Vec2>& points) const {
  if (!way_) return;
  DistinctPoints distinct(points);
  way_->forward(distinct.points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2& local = distinct.points[distinct.which[i]];
    if (!local.allFinite()) {
      throw InputError(
          name_, {.says = fmt::format("PROJ cannot convert ({}, {}) to metres about the origin",
                                      points[i].x(), points[i].y()),
                  .advice = "is the coordinate reference system right?"});
    }
    points[i] = local;
  }
}

CellLean lean_of(const CellGrid& grid, int width, int height,
                 const std::optional<ProjReference>& crs, const std::optional<Vec2>& origin) {
  constexpr CellLean kUnknown{std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::infinity()};
  std::optional<ProjWay> way;
  if (crs) {
    const auto to_places = ProjWay::to_places(*crs);
    const auto middle =
        to_places ? to_places->place_of(grid.corner(0.5 * width, 0.5 * height)) : std::nullopt;
    if (middle) way = ProjWay::to_plane(*crs, origin_at(*middle, origin));
    if (!way) return kUnknown;
  }
  CellLean lean;
  for (int i = 0; i < 9; ++i) {
    const double column = i % 3 * std::floor(0.5 * (width - 1));
    const double row = i / 3 * std::floor(0.5 * (height - 1));
    std::array<Vec2, 3> p{grid.corner(column, row), grid.corner(column + 1, row),
                          grid.corner(column, row + 1)};
    if (way) way->forward(p);
    if (!p[0].allFinite() || !p[1].allFinite() || !p[2].allFinite()) return kUnknown;
    lean.column = std::max(lean.column, (p[1] - p[0]).cwiseAbs().minCoeff());
    lean.row = std::max(lean.row, (p[2] - p[0]).cwiseAbs().minCoeff());
  }
  return lean;
}

}  // namespace geom::gis
