#include "geom/earth/proj_way.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <numbers>
#include <utility>
#include <vector>

#include "proj_objects.h"

namespace geom {
namespace {

constexpr double kSame =
    0.01;  // metres between a point and where it is after the way back and there
constexpr double kSameDegrees = 1e-7;

// An operation as a pipeline that more steps may follow: points pass through PJs one by one, and
// each costs. Empty where PROJ chooses among several operations for each point.
std::string steps_of(PJ_CONTEXT* context, const PJ* operation) {
  const char* const text = proj().text_of(context, operation, PJ_PROJ_5, nullptr);
  if (!text) return "";
  const std::string steps = text;
  return steps.starts_with("+proj=pipeline") ? steps : "+proj=pipeline +step " + steps;
}

// To longitude and latitude; null where PROJ knows no way.
ProjObject search(PJ_CONTEXT* context, const PJ* from) {
  const WatchedProj watched(context);
  const ProjObject earth(proj().create(context, "EPSG:4326"));
  const char* const options[] = {"ALLOW_BALLPARK=NO", nullptr};
  const ProjObject way(earth ? proj().way(context, from, earth.get(), nullptr, options) : nullptr);
  ProjObject out(way ? proj().normalize(context, way.get()) : nullptr);
  watched.require_none();
  return out;
}

// Places of the whole Earth, or of the area that a system is meant for, by the way back.
std::vector<Vec2> sample_of(PJ* way, const std::optional<ProjReference::Area>& area) {
  constexpr int kSide = 48;
  const auto [west, south, east, north] = area.value_or(ProjReference::Area{-180, -90, 180, 90});
  const double width = east < west ? east + 360 - west : east - west;
  std::vector<Vec2> out;
  for (int i = 0; i < kSide * kSide; ++i) {
    out.emplace_back(west + width * (i % kSide + 0.5) / kSide,
                     south + (north - south) * (i / kSide + 0.5) / kSide);
  }
  proj().transform(way, PJ_INV, out.data()->data(), sizeof(Vec2), out.size(),
                   out.data()->data() + 1, sizeof(Vec2), out.size(), nullptr, 0, 0, nullptr, 0, 0);
  return out;
}

}  // namespace

struct ProjWay::Impl {
  std::shared_ptr<ProjReference::Impl> from;
  // Where the way leads to metres: all of it as one operation, or from degrees on.
  ProjObject joined = nullptr;
  ProjObject plane = nullptr;

  void convert(double* x, std::size_t count, std::size_t stride, PJ_DIRECTION direction) const {
    const WatchedMemory memory;
    PJ* const first = joined ? joined.get() : from->to_places.get();
    if (direction == PJ_FWD) convert(first, x, count, stride, direction);
    if (plane) convert(plane.get(), x, count, stride, direction);
    if (direction == PJ_INV) convert(first, x, count, stride, direction);
    memory.require_enough();
  }

  // Searches once more, with a context that has seen nothing yet. Throws std::bad_alloc where PROJ
  // finds another way: it takes a failure of SQLite for an empty answer.
  static void require_found_again(const ProjReference& known) {
    const std::optional<ProjReference> fresh = ProjReference::of(known.told().crs);
    if (!fresh) throw std::bad_alloc();
    const ProjObject again = search(fresh->impl_->context.get(), fresh->impl_->plane.get());
    PJ* const way = known.impl_->to_places.get();
    if (!way && !again) return;
    if (!way || !again) throw std::bad_alloc();
    const auto area = fresh->area();
    const std::vector<Vec2> points = sample_of(way, area);
    const std::vector<Vec2> others = sample_of(again.get(), area);
    const bool same = std::equal(
        points.begin(), points.end(), others.begin(),
        [](const Vec2& a, const Vec2& b) { return a == b || (!a.allFinite() && !b.allFinite()); });
    if (!same) throw std::bad_alloc();
  }

 private:
  static void convert(PJ* by, double* x, std::size_t count, std::size_t stride,
                      PJ_DIRECTION direction) {
    proj().transform(by, direction, x, stride, count, x + 1, stride, count, nullptr, 0, 0, nullptr,
                     0, 0);
  }
};

ProjWay::ProjWay(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ProjWay::~ProjWay() = default;
ProjWay::ProjWay(ProjWay&&) noexcept = default;
ProjWay& ProjWay::operator=(ProjWay&&) noexcept = default;

std::optional<ProjWay> ProjWay::to_places(const ProjReference& from) {
  ProjReference::Impl& known = *from.impl_;
  if (!known.searched && from.places()) {
    PJ_CONTEXT* const context = known.context.get();
    known.to_places = search(context, known.plane.get());
    known.chooses = known.to_places && steps_of(context, known.to_places.get()).empty();
    if (!proj().watches_sqlite) Impl::require_found_again(from);
  }
  known.searched = true;
  if (!known.to_places) return std::nullopt;
  return ProjWay(std::make_unique<Impl>(Impl{from.impl_}));
}

std::optional<ProjWay> ProjWay::to_plane(const ProjReference& from, const GeodeticOrigin& origin) {
  std::optional<ProjWay> out = to_places(from);
  if (!out) return std::nullopt;
  const std::string plane = fmt::format(
      " +step +proj=unitconvert +xy_in=deg +xy_out=rad "
      "+step +proj=tmerc +lat_0={} +lon_0={} +k=1 +x_0=0 +y_0=0 +ellps=WGS84",
      origin.latitude, origin.longitude);
  PJ_CONTEXT* const context = from.impl_->context.get();
  Impl& way = *out->impl_;
  const WatchedMemory memory;
  const std::string before = steps_of(context, from.impl_->to_places.get());
  if (!before.empty()) {
    const WatchedProj watched(context);
    way.joined.reset(proj().create(context, (before + plane).c_str()));
    if (watched.failed()) way.joined.reset();
  }
  if (!way.joined) {
    const WatchedProj watched(context);
    way.plane.reset(proj().create(context, ("+proj=pipeline" + plane).c_str()));
    watched.require_none();
  }
  memory.require_enough();
  if (!way.joined && !way.plane) return std::nullopt;
  return out;
}

void ProjWay::forward(std::span<Vec2> points) const {
  if (!points.empty()) forward(points.data()->data(), points.size(), sizeof(Vec2));
}

void ProjWay::forward(double* x, std::size_t count, std::size_t stride) const {
  impl_->convert(x, count, stride, PJ_FWD);
}

// Where PROJ chooses among several operations for each point, it may choose another one for the way
// back than for the way there, near the edge of the areas that these are meant for.
void ProjWay::back(std::span<Vec2> points) const {
  if (points.empty()) return;
  const std::vector<Vec2> before(points.begin(), points.end());
  impl_->convert(points.data()->data(), points.size(), sizeof(Vec2), PJ_INV);
  if (!impl_->from->chooses) return;
  std::vector<Vec2> again(points.begin(), points.end());
  forward(again);
  const bool metres = impl_->joined || impl_->plane;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if ((again[i] - before[i]).norm() <= (metres ? kSame : kSameDegrees)) continue;
    points[i].setConstant(std::numeric_limits<double>::infinity());
  }
}

std::optional<Vec2> ProjWay::place_of(Vec2 point) const {
  forward({&point, 1});
  return point.allFinite() ? std::optional(point) : std::nullopt;
}

// What is within a closed line on the one side is within it on the other.
std::optional<Aabb> ProjWay::origin_of(const Aabb& region) const {
  constexpr int kSteps = 100;  // a side
  const Vec2 low = region.min.head<2>();
  const Vec2 size = region.max.head<2>() - low;
  std::vector<Vec2> line;
  for (const auto& [from, step] : {std::pair(Vec2(0, 0), Vec2(1, 0)),
                                   {Vec2(1, 0), Vec2(0, 1)},
                                   {Vec2(1, 1), Vec2(-1, 0)},
                                   {Vec2(0, 1), Vec2(0, -1)}}) {
    for (int i = 0; i < kSteps; ++i) {
      line.push_back(low + (from + step * i / kSteps).cwiseProduct(size));
    }
  }
  back(line);
  Aabb out = region;
  out.min.head<2>() = out.max.head<2>() = line.front();
  const bool degrees = ProjReference(impl_->from).is_geographic();
  const double turn = 2 * std::numbers::pi / ProjReference(impl_->from).unit().value_or(1);
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vec2& p = line[i];
    const Vec2& next = line[(i + 1) % line.size()];
    if (!p.allFinite() || (degrees && std::abs(next.x() - p.x()) > turn / 2)) return std::nullopt;
    out.min.head<2>() = out.min.head<2>().cwiseMin(p);
    out.max.head<2>() = out.max.head<2>().cwiseMax(p);
  }
  const Vec3 more = 0.01 * (out.max - out.min);
  return Aabb{out.min - more, out.max + more};
}

GeodeticOrigin tidy_origin(const Vec2& place, double parts) {
  const Vec2 tidy = (place * parts).array().round() / parts;
  return {tidy.y(), tidy.x(), 0};
}

}  // namespace geom
