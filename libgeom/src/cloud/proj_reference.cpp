#include "geom/cloud/proj_reference.h"

#include <fmt/format.h>

#include <utility>

#include "geom/base/error.h"
#include "proj_library.h"

namespace geom {
namespace {

using Kind = CoordinateReference::Kind;

struct ContextCloser {
  void operator()(PJ_CONTEXT* context) const { proj().context_destroy(context); }
};
using Context = std::unique_ptr<PJ_CONTEXT, ContextCloser>;

struct ObjectCloser {
  void operator()(PJ* object) const { proj().destroy(object); }
};
using Object = std::unique_ptr<PJ, ObjectCloser>;

// One that says nothing by itself and never asks the network.
Context quiet_context() {
  Context context(proj().context_create());
  proj().log_level(context.get(), PJ_LOG_NONE);
  proj().enable_network(context.get(), 0);
  return context;
}

// The metres (for an angle, radians) in a unit of the axis.
std::optional<double> axis_unit(PJ_CONTEXT* context, const PJ* system, int axis) {
  const Object axes(proj().axes(context, system));
  double unit = 0;
  if (!axes || axis >= proj().axis_count(context, axes.get()) ||
      !proj().axis_info(context, axes.get(), axis, nullptr, nullptr, nullptr, &unit, nullptr,
                        nullptr, nullptr) ||
      !(unit > 0 && unit < 1e9)) {
    return std::nullopt;
  }
  return unit;
}

bool points_down(PJ_CONTEXT* context, const PJ* system, int axis) {
  const Object axes(proj().axes(context, system));
  const char* direction = nullptr;
  return axes && axis < proj().axis_count(context, axes.get()) &&
         proj().axis_info(context, axes.get(), axis, nullptr, nullptr, &direction, nullptr, nullptr,
                          nullptr, nullptr) &&
         direction && std::string_view(direction) == "down";
}

int axis_count(PJ_CONTEXT* context, const PJ* system) {
  const Object axes(proj().axes(context, system));
  return axes ? proj().axis_count(context, axes.get()) : 0;
}

// Mercator, whose scale grows with the latitude; not the transverse and oblique ones.
bool is_mercator(PJ_CONTEXT* context, const PJ* system) {
  const Object conversion(proj().conversion(context, system));
  const char* method = nullptr;
  if (!conversion || !proj().method_info(context, conversion.get(), &method, nullptr, nullptr) ||
      !method) {
    return false;
  }
  const std::string name = method;
  return name.starts_with("Mercator") || name.find("Pseudo") != std::string::npos;
}

Kind kind_of(PJ_CONTEXT* context, const PJ* system) {
  switch (proj().type_of(system)) {
    case PJ_TYPE_PROJECTED_CRS:
      return is_mercator(context, system) ? Kind::no_plane : Kind::metric;
    case PJ_TYPE_ENGINEERING_CRS:
      return Kind::metric;
    case PJ_TYPE_GEOGRAPHIC_2D_CRS:
    case PJ_TYPE_GEOGRAPHIC_3D_CRS:
    case PJ_TYPE_GEOCENTRIC_CRS:
      return Kind::no_plane;
    default:
      return Kind::not_known;
  }
}

}  // namespace

std::string plane_about(const GeodeticOrigin& origin) {
  return fmt::format(
      "+proj=tmerc +lat_0={} +lon_0={} +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m +no_defs",
      origin.latitude, origin.longitude);
}

struct ProjReference::Impl {
  Context context = quiet_context();
  Object whole;
  Object plane;   // the part of x and y
  Object height;  // of heights, where these have a part of their own
};

ProjReference::ProjReference(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ProjReference::~ProjReference() = default;
ProjReference::ProjReference(ProjReference&&) noexcept = default;
ProjReference& ProjReference::operator=(ProjReference&&) noexcept = default;

std::optional<ProjReference> ProjReference::of(const std::string& text) {
  auto impl = std::make_unique<Impl>();
  PJ_CONTEXT* const context = impl->context.get();
  impl->whole.reset(proj().create(context, text.c_str()));
  // A PROJ string without +type=crs is an operation.
  if (impl->whole && !proj().is_crs(impl->whole.get())) {
    impl->whole.reset(proj().create(context, (text + " +type=crs").c_str()));
  }
  if (!impl->whole || !proj().is_crs(impl->whole.get())) return std::nullopt;
  impl->plane.reset(proj().clone(context, impl->whole.get()));
  if (proj().type_of(impl->plane.get()) == PJ_TYPE_COMPOUND_CRS) {
    impl->height.reset(proj().part(context, impl->whole.get(), 1));
    impl->plane.reset(proj().part(context, impl->whole.get(), 0));
  }
  if (!impl->plane) return std::nullopt;
  // What a system is bound to by its transformation is kept for the way; here its own axes count.
  Object axes(proj().clone(context, impl->plane.get()));
  if (proj().type_of(axes.get()) == PJ_TYPE_BOUND_CRS) {
    axes.reset(proj().source_of(context, axes.get()));
  }
  if (!axes) return std::nullopt;
  CoordinateReference told;
  told.kind = kind_of(context, axes.get());
  told.crs = text;
  const char* const name = proj().name_of(impl->whole.get());
  told.name = name && *name ? name : text.substr(0, 60);
  if (told.kind == Kind::metric) {
    told.plane = axis_unit(context, axes.get(), 0);
    if (told.plane != axis_unit(context, axes.get(), 1)) told.plane.reset();
  }
  if (impl->height) {
    Object height(proj().clone(context, impl->height.get()));
    if (proj().type_of(height.get()) == PJ_TYPE_BOUND_CRS) {
      height.reset(proj().source_of(context, height.get()));
    }
    told.up = axis_unit(context, height.get(), 0);
    told.up_unclear = !told.up;
    told.depths = points_down(context, height.get(), 0);
  } else if (axis_count(context, axes.get()) > 2) {
    told.up = axis_unit(context, axes.get(), 2);
    told.depths = points_down(context, axes.get(), 2);
  }
  ProjReference out(std::move(impl));
  out.told_ = std::move(told);
  return out;
}

bool ProjReference::places() const {
  PJ_TYPE type = proj().type_of(impl_->plane.get());
  if (type == PJ_TYPE_BOUND_CRS) {
    const Object source(proj().source_of(impl_->context.get(), impl_->plane.get()));
    type = proj().type_of(source.get());
  }
  return type == PJ_TYPE_PROJECTED_CRS || type == PJ_TYPE_GEOGRAPHIC_2D_CRS ||
         type == PJ_TYPE_GEOGRAPHIC_3D_CRS;
}

struct ProjWay::Impl {
  Context context = quiet_context();
  Object way;
  std::string source;
  std::string name;
};

namespace {

// From the plane of a system to another, x before y; never one that takes two datums for one.
Object way_between(PJ_CONTEXT* context, const PJ* from, const std::string& to) {
  const Object target(proj().create(context, to.c_str()));
  const char* const options[] = {"ALLOW_BALLPARK=NO", nullptr};
  const Object way(target ? proj().way(context, from, target.get(), nullptr, options) : nullptr);
  return Object(way ? proj().normalize(context, way.get()) : nullptr);
}

[[noreturn]] void no_way(const std::string& source, const std::string& name) {
  throw InputError(
      source,
      {.says = fmt::format("PROJ knows no way from the reference system \"{}\" to places on Earth",
                           name.substr(0, 80)),
       .advice = "say which it is with --crs, for example --crs EPSG:25832"});
}

}  // namespace

ProjWay::ProjWay(const ProjReference& from, const std::string& to, const std::string& source)
    : impl_(std::make_unique<Impl>()) {
  impl_->source = source;
  impl_->name = from.told().name;
  if (!from.places()) no_way(source, impl_->name);
  impl_->way = way_between(impl_->context.get(), from.impl_->plane.get(), to);
  if (!impl_->way) no_way(source, impl_->name);
}
ProjWay::~ProjWay() = default;
ProjWay::ProjWay(ProjWay&&) noexcept = default;
ProjWay& ProjWay::operator=(ProjWay&&) noexcept = default;

void ProjWay::project(std::span<CloudPoint> points) const {
  if (points.empty()) return;
  const Vec3 first = points.front().position;
  const std::size_t stride = sizeof(CloudPoint);
  proj().transform(impl_->way.get(), PJ_FWD, &points[0].position.x(), stride, points.size(),
                   &points[0].position.y(), stride, points.size(), nullptr, 0, 0, nullptr, 0, 0);
  for (const CloudPoint& p : points) {
    if (p.position.allFinite()) continue;
    throw InputError(
        impl_->source,
        {.says = fmt::format("PROJ cannot tell where on Earth a point is: it, or one read with it, "
                             "is near ({}, {}) of \"{}\"; is that the right reference system?",
                             first.x(), first.y(), impl_->name.substr(0, 80))});
  }
}

std::optional<Aabb> ProjWay::origin_of(const Aabb& region) const {
  constexpr int kPointsASide = 101;
  Aabb out = region;
  const bool told =
      proj().transform_bounds(impl_->context.get(), impl_->way.get(), PJ_INV, region.min.x(),
                              region.min.y(), region.max.x(), region.max.y(), &out.min.x(),
                              &out.min.y(), &out.max.x(), &out.max.y(), kPointsASide);
  if (!told || !out.min.allFinite() || !out.max.allFinite() || out.min.x() > out.max.x()) {
    return std::nullopt;
  }
  const Vec3 more = 0.01 * (out.max - out.min);
  return Aabb{out.min - more, out.max + more};
}

ProjWay way_to_plane(const ProjReference& from, const GeodeticOrigin& origin,
                     const std::string& source) {
  return ProjWay(from, plane_about(origin) + " +type=crs", source);
}

GeodeticOrigin origin_near(const ProjReference& reference, const Vec3& point,
                           const std::string& source) {
  CloudPoint place{point};
  ProjWay(reference, "EPSG:4326", source).project({&place, 1});  // longitude before latitude
  const Vec3 tidy = (place.position * 1e3).array().round() / 1e3;
  return {tidy.y(), tidy.x(), 0};
}

}  // namespace geom
