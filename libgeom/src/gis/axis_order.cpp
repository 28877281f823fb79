#include "geom/gis/axis_order.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <regex>

#include "import/city_footprints.h"
#include "required_reference.h"

namespace geom::gis {
namespace {

struct NamedCrs {
  std::string crs;
  bool own_order = false;  // the axes are in the order of the system
};

// "ETRS89_UTM32*DE_DHHN92_NH": systems of the German surveys, all east first, heights in metres.
std::optional<NamedCrs> german(const std::string& name) {
  static const std::regex form(
      R"(urn:adv:crs:(ETRS89_UTM(2[89]|3[0-8])|DE_DHDN_3GK([2-5]))(_[A-Z0-9_]*)?(\*DE_DHH?N.*)?)");
  std::smatch found;
  if (!std::regex_match(name, found, form)) return std::nullopt;
  const std::string code =
      found[2].matched ? "258" + found[2].str() : std::to_string(31464 + std::stoi(found[3].str()));
  return NamedCrs{"EPSG:" + code};
}

NamedCrs named(const std::string& name, bool city_json) {
  if (const auto known = german(name)) return *known;
  if (name == "CRS:84") return {"OGC:CRS84"};
  if (name == "osgb:BNG") return {"EPSG:27700"};
  static const std::regex code_form(R"(EPSG[:/]+[^:/,#]*[:/]+([0-9]{1,7})(?![0-9.]))");
  static const std::regex plain(R"((?:.*gml/srs/epsg\.xml#|EPSG:)([0-9]{1,7}))");
  std::smatch found;
  if (std::regex_match(name, found, plain)) {
    return {"EPSG:" + found[1].str()};
  }
  const bool ogc = name.starts_with("urn:ogc:def:crs") || name.starts_with("urn:x-ogc:def:crs") ||
                   name.find("opengis.net/def/crs") != std::string::npos;
  std::vector<std::string> codes;
  for (auto at = std::sregex_iterator(name.begin(), name.end(), code_form);
       ogc && at != std::sregex_iterator(); ++at) {
    codes.push_back((*at)[1].str());
  }
  if (codes.empty() || codes.size() > 2) return {name};
  NamedCrs out{"EPSG:" + codes[0], !city_json};
  if (codes.size() == 2) out.crs += "+" + codes[1];
  return out;
}

// Whether the point (x to the east) lies where the system is meant for; nothing where that is not
// said.
std::optional<bool> in_area(const ProjReference& system, const Vec2& p) {
  const auto area = system.area();
  const auto way = ProjWay::to_places(system);
  if (!area || !way) return std::nullopt;
  const auto place = way->place_of(p);
  if (!place) return false;
  constexpr double kNear = 0.5;  // degrees
  const bool across_date_line = area->west > area->east;
  const bool behind_west = place->x() >= area->west - kNear;
  const bool before_east = place->x() <= area->east + kNear;
  return (across_date_line ? behind_west || before_east : behind_west && before_east) &&
         place->y() >= area->south - kNear && place->y() <= area->north + kNear;
}

template <class F>
void for_each_surface(CityModel& model, const F& f) {
  for (CityObject& object : model.objects) {
    for (CityGeometry& geometry : object.geometries) {
      for (CitySurface& surface : geometry.surfaces) f(surface);
    }
  }
}

Vec2 middle_of(CityModel& model) {
  std::optional<std::pair<Vec2, Vec2>> reach;
  for_each_surface(model, [&](const CitySurface& surface) {
    for (const Vec3& p : surface[0]) {
      const Vec2 at = p.head<2>();
      reach = reach ? std::pair(reach->first.cwiseMin(at), reach->second.cwiseMax(at))
                    : std::pair(at, at);
    }
  });
  return reach ? Vec2(0.5 * (reach->first + reach->second)) : Vec2::Zero();
}

// Of solids, the share of the volume below their surfaces that these say is inside, 1 where all
// face outward, -1 where all face inward.
double outwardness(const CityModel& model) {
  double sum = 0;
  double all = 0;
  for (const CityObject& object : model.objects) {
    for (const CityGeometry& geometry : object.geometries) {
      double low = kLargestCoordinate;
      for (const auto& surface : geometry.surfaces) {
        for (const Vec3& p : surface[0]) low = std::min(low, p.z());
      }
      for (const auto& surface : geometry.surfaces) {
        double twice = 0;
        double height = 0;
        const auto& ring = surface[0];
        for (std::size_t i = 0; i < ring.size(); ++i) {
          const Vec3 a = ring[i] - ring[0];
          const Vec3 b = ring[(i + 1) % ring.size()] - ring[0];
          twice += a.x() * b.y() - a.y() * b.x();
          height += (ring[i].z() - low) / static_cast<double>(ring.size());
        }
        sum += twice * height;
        all += std::abs(twice * height);
      }
    }
  }
  return all > 0 ? sum / all : 0;
}

[[noreturn]] void refuse_order(const std::string& name, const std::string& system, bool north_first,
                               const std::string& why) {
  throw InputError(
      name,
      {.says = fmt::format("\"{}\" means coordinates with the {} first, but {}",
                           system.substr(0, 80), north_first ? "north (or latitude)" : "east", why),
       .advice = "say which comes first with --axes east-north or --axes north-east"});
}

// Whether to exchange x and y.
bool north_comes_first(CityModel& model, const ProjReference& system, bool own_order,
                       const std::string& name) {
  const bool north_first = own_order && system.north_first();
  const Vec2 p = middle_of(model);
  const Vec2 q(p.y(), p.x());
  const auto as_named = in_area(system, north_first ? q : p);
  const auto exchanged = in_area(system, north_first ? p : q);
  if (!as_named || !exchanged || !*exchanged) return north_first;
  if (!*as_named) {
    refuse_order(name, model.crs, north_first,
                 "they lie where that system is meant for only the other way round");
  }
  const double outward = outwardness(model) * (north_first ? -1 : 1);
  if (outward < -0.5) {
    refuse_order(name, model.crs, north_first, "then the surfaces face inward, as in a mirror");
  }
  return north_first;
}

}  // namespace

std::optional<ProjReference> orient(CityModel& model, Axes axes, bool city_json,
                                    const std::string& name) {
  const NamedCrs crs = named(model.crs, city_json);
  std::optional<ProjReference> system;
  if (!crs.crs.empty()) system = required_reference(crs.crs, name);
  bool exchange = axes == Axes::north_east;
  if (axes == Axes::as_named && system) {
    exchange = north_comes_first(model, *system, crs.own_order, name);
  }
  if (exchange) {
    for_each_surface(model, [](CitySurface& surface) {
      for (auto& ring : surface) {
        for (Vec3& p : ring) std::swap(p.x(), p.y());
      }
    });
  }
  model.crs = crs.crs;
  return system;
}

void require_metres(const std::string& srs_name, const std::string& name) {
  const ProjReference system = required_reference(named(srs_name, false).crs, name);
  if (!system.is_geographic() && std::abs(system.unit().value_or(0) - 1) < 1e-9) return;
  throw InputError(name, {.expected = "coordinates in metres where shapes are placed by a matrix",
                          .found = "a coordinate reference system that counts otherwise",
                          .advice = "convert the file"});
}

}  // namespace geom::gis
