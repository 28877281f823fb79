#include "geom/earth/proj_reference.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

#include "proj_objects.h"

namespace geom {
namespace {

using Kind = CoordinateReference::Kind;

// One that says nothing by itself and never asks the network.
ProjContext quiet_context() {
  ProjContext context(proj().context_create());
  proj().log_level(context.get(), PJ_LOG_NONE);
  proj().enable_network(context.get(), 0);
  proj().use_init_rules(context.get(), 1);
  return context;
}

struct Axis {
  std::string name;
  std::string direction;
  double unit = 0;  // metres or radians
};

std::optional<Axis> axis_of(PJ_CONTEXT* context, const PJ* system, int number) {
  const ProjObject axes(proj().axes(context, system));
  const char* name = nullptr;
  const char* direction = nullptr;
  Axis out;
  if (!axes || number >= proj().axis_count(context, axes.get()) ||
      !proj().axis_info(context, axes.get(), number, &name, nullptr, &direction, &out.unit, nullptr,
                        nullptr, nullptr)) {
    return std::nullopt;
  }
  out.name = name ? name : "";
  out.direction = direction ? direction : "";
  return out;
}

std::optional<double> unit_of(const std::optional<Axis>& axis) {
  return axis && axis->unit > 0 && axis->unit < 1e9 ? std::optional(axis->unit) : std::nullopt;
}

// Mercator, whose scale grows with the latitude; not the transverse and oblique ones.
bool is_mercator(PJ_CONTEXT* context, const PJ* system) {
  const ProjObject conversion(proj().conversion(context, system));
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

ProjObject unbound(PJ_CONTEXT* context, const PJ* system) {
  return ProjObject(proj().type_of(system) == PJ_TYPE_BOUND_CRS ? proj().source_of(context, system)
                                                                : proj().clone(context, system));
}

// Letters and digits in lower case.
std::string bare(std::string_view name) {
  std::string out;
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c))) {
      out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  return out;
}

std::string name_of(const PJ* system) {
  const char* const name = proj().name_of(system);
  return name ? name : "";
}

// Whether a text defines a system, beyond naming one: well-known text, JSON, a PROJ string.
bool is_definition(const std::string& text) { return text.find_first_of("[{=") != text.npos; }

// PROJ takes a part of a name for the whole, which would be a guess.
bool is_guess(const std::string& text, const PJ* system) {
  const bool is_name = text.find(':') == text.npos && !is_definition(text);
  return is_name && bare(text) != bare(name_of(system));
}

// A code is replaced where its definition was wrong, so that whoever names it means the other.
void replace_deprecated(PJ_CONTEXT* context, ProjObject& system) {
  if (!proj().is_deprecated(system.get())) return;
  PJ_OBJ_LIST* const others = proj().replacements(context, system.get());
  if (others && proj().list_count(others) == 1) {
    if (ProjObject other{proj().list_get(context, others, 0)}) system = std::move(other);
  }
  if (others) proj().list_destroy(others);
}

// What a text defines and PROJ's database has, too, is better known there: where it is meant for.
void take_from_database(PJ_CONTEXT* context, ProjObject& system) {
  const char* const authority = proj().authority_of(system.get(), 0);
  const char* const code = proj().code_of(system.get(), 0);
  if (!authority || !code) return;
  ProjObject known(proj().create(context, (std::string(authority) + ":" + code).c_str()));
  if (known && proj().is_equivalent(system.get(), known.get(),
                                    PJ_COMP_EQUIVALENT_EXCEPT_AXIS_ORDER_GEOGCRS)) {
    system = std::move(known);
  }
}

// Null where PROJ knows none.
ProjObject system_of(PJ_CONTEXT* context, const std::string& text) {
  ProjObject out(proj().create(context, text.c_str()));
  // A PROJ string without +type=crs is an operation.
  if (out && !proj().is_crs(out.get())) {
    out.reset(proj().create(context, (text + " +type=crs").c_str()));
  }
  if (!out || !proj().is_crs(out.get()) || is_guess(text, out.get())) return nullptr;
  if (!is_definition(text)) replace_deprecated(context, out);
  return out;
}

CoordinateReference told_of(PJ_CONTEXT* context, const PJ* whole, const PJ* own,
                            const std::string& text) {
  CoordinateReference told;
  told.kind = kind_of(context, own);
  told.crs = text;
  told.name = name_of(whole);
  if (told.name.empty()) told.name = text.substr(0, 60);
  if (told.kind == Kind::metric) {
    told.plane = unit_of(axis_of(context, own, 0));
    if (told.plane != unit_of(axis_of(context, own, 1))) told.plane.reset();
  }
  std::optional<Axis> up = axis_of(context, own, 2);
  if (proj().type_of(whole) == PJ_TYPE_COMPOUND_CRS) {
    if (const ProjObject part{proj().part(context, whole, 1)}) {
      const ProjObject heights = unbound(context, part.get());
      up = heights ? axis_of(context, heights.get(), 0) : std::nullopt;
      told.up_unclear = !unit_of(up);
    }
  }
  told.up = unit_of(up);
  told.depths = up && up->direction == "down";
  return told;
}

}  // namespace

std::optional<ProjReference> ProjReference::of(const std::string& text) {
  const WatchedMemory memory;
  auto impl = std::make_shared<Impl>();
  impl->context = quiet_context();
  PJ_CONTEXT* const context = impl->context.get();
  const WatchedProj watched(context);
  impl->whole = system_of(context, text);
  memory.require_enough();  // else it may be known all the same
  if (!impl->whole) return std::nullopt;
  impl->plane.reset(proj().type_of(impl->whole.get()) == PJ_TYPE_COMPOUND_CRS
                        ? proj().part(context, impl->whole.get(), 0)
                        : proj().clone(context, impl->whole.get()));
  if (!impl->plane) return std::nullopt;
  if (is_definition(text)) take_from_database(context, impl->plane);
  impl->own = unbound(context, impl->plane.get());
  if (!impl->own) return std::nullopt;
  impl->told = told_of(context, impl->whole.get(), impl->own.get(), text);
  watched.require_none();
  memory.require_enough();
  return ProjReference(std::move(impl));
}

const CoordinateReference& ProjReference::told() const { return impl_->told; }

bool ProjReference::places() const {
  return is_geographic() || proj().type_of(impl_->own.get()) == PJ_TYPE_PROJECTED_CRS;
}

bool ProjReference::is_geographic() const {
  const PJ_TYPE type = proj().type_of(impl_->own.get());
  return type == PJ_TYPE_GEOGRAPHIC_2D_CRS || type == PJ_TYPE_GEOGRAPHIC_3D_CRS;
}

std::optional<double> ProjReference::unit() const {
  return unit_of(axis_of(impl_->context.get(), impl_->own.get(), 0));
}

bool ProjReference::north_first() const {
  const WatchedMemory memory;
  PJ_CONTEXT* const context = impl_->context.get();
  const ProjObject x_first(proj().normalize(context, impl_->own.get()));
  const auto own = axis_of(context, impl_->own.get(), 0);
  const auto x = x_first ? axis_of(context, x_first.get(), 0) : std::nullopt;
  memory.require_enough();
  return own && x && own->name != x->name;
}

std::optional<ProjReference::Area> ProjReference::area() const {
  for (const PJ* system : {impl_->whole.get(), impl_->plane.get()}) {
    Area out;
    constexpr double kNone = -1000;  // as PROJ says it
    if (proj().area_of(impl_->context.get(), system, &out.west, &out.south, &out.east, &out.north,
                       nullptr) &&
        out.west != kNone) {
      return out;
    }
  }
  return std::nullopt;
}

}  // namespace geom
