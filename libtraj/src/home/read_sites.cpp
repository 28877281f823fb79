#include <fmt/format.h>

#include <cmath>
#include <istream>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "geom/base/error.h"
#include "geom/base/precondition.h"
#include "geom/map/geographic_frame.h"
#include "geom/text/geojson_crs.h"
#include "geom/text/parse_json.h"
#include "traj/home/landing_site.h"

namespace traj {
namespace {

using Json = nlohmann::json;
using geom::Fault;
using geom::InputError;
using geom::Vec2;

constexpr double kFar = 1e6;  // m from the origin

class SiteReader {
 public:
  SiteReader(std::string_view source, const geom::Frame& frame, const SiteReading& reading)
      : source_(source), frame_(frame), local_(reading.local) {
    if (local_) return;
    if (!geom::counts_from_origin(frame)) {
      throw InputError(
          source_,
          {.says =
               "the map has no origin on Earth, so longitudes and latitudes have no place on it",
           .advice = "give coordinates in the map's metres, with --home-local"});
    }
    earth_ = std::make_unique<geom::GeographicFrame>(*frame.origin);
  }

  std::vector<DrawnSite> read(std::istream& in) {
    const Json root = geom::parse_json(in, source_);
    if (!root.is_object()) refuse({.expected = "a GeoJSON object", .found = geom::shown(root)});
    require_wgs84(root);
    if (root.value("type", Json()) == "FeatureCollection") {
      const Json features = root.value("features", Json());
      if (!features.is_array()) {
        throw InputError(source_,
                         {.expected = "\"features\" to be a list", .found = geom::shown(features)});
      }
      for (const Json& feature : features) add(feature);
    } else {
      add(root.value("type", Json()) == "Feature" ? root : Json{{"geometry", root}});
    }
    if (sites_.empty()) {
      throw InputError(source_, {.expected = "at least one landing site", .found = "none"});
    }
    return std::move(sites_);
  }

 private:
  [[noreturn]] void refuse(Fault fault) const {
    throw InputError(source_, geom::within(fmt::format("feature {}", number_), std::move(fault)));
  }

  void require_wgs84(const Json& object) const {
    if (!local_ && geom::has_foreign_crs(object)) throw InputError(source_, geom::foreign_crs());
  }

  void add(const Json& feature) {
    ++number_;
    const Json geometry = feature.is_object() ? feature.value("geometry", Json()) : Json();
    if (!geometry.is_object()) refuse({.expected = "a feature with a geometry", .found = "none"});
    require_wgs84(feature);
    require_wgs84(geometry);
    const Json properties = feature.value("properties", Json());
    DrawnSite site{id_of(feature, properties), number_, {}, {}};
    if (!ids_.insert(site.id).second) {
      refuse(
          {.key = "id", .expected = "its own", .found = geom::in_quotes(site.id) + " once more"});
    }
    const Json coordinates = geometry.value("coordinates", Json());
    const Json type = geometry.value("type", Json());
    if (type == "Point") {
      site.outline.outer = {place(coordinates)};
      site.ground = ground_of(properties, coordinates);
    } else if (type == "Polygon") {
      site.outline = polygon(coordinates);
      site.ground = ground_of(properties, Json());
    } else {
      refuse({.expected = "a Point or a Polygon", .found = geom::shown(type)});
    }
    sites_.push_back(std::move(site));
  }

  std::string id_of(const Json& feature, const Json& properties) const {
    for (const auto& [object, key] : {std::pair(&feature, "id"), std::pair(&properties, "id"),
                                      std::pair(&properties, "name")}) {
      if (!object->is_object() || !object->contains(key)) continue;
      const Json& value = (*object)[key];
      if (value.is_string()) return value.get<std::string>();
      if (value.is_number()) return value.dump();
    }
    return fmt::format("site-{}", number_);
  }

  std::optional<double> ground_of(const Json& properties, const Json& position) const {
    std::optional<double> said;
    if (properties.is_object() && properties.contains("ground")) {
      said = metres(properties["ground"], "ground");
    }
    if (!position.is_array() || position.size() < 3) return said;
    const double zero = local_ || !frame_.origin ? 0 : frame_.origin->height;
    const double height = metres(position[2], "the third coordinate") - zero;
    if (said && std::abs(*said - height) > kLevelGround) {
      refuse({.key = "ground",
              .expected = fmt::format("{} m of the map's z, as the third coordinate says", height),
              .found = fmt::to_string(*said)});
    }
    return said.value_or(height);
  }

  double metres(const Json& value, const char* key) const {
    if (!value.is_number() || !(std::abs(value.get<double>()) <= geom::kLargestCoordinate)) {
      refuse({.key = key, .expected = "metres", .found = geom::shown(value)});
    }
    return value.get<double>();
  }

  geom::Polygon polygon(const Json& rings) const {
    if (!rings.is_array() || rings.empty()) refuse({.says = "a polygon must have rings"});
    geom::Polygon out{ring(rings[0]), {}};
    for (std::size_t i = 1; i < rings.size(); ++i) out.holes.push_back(ring(rings[i]));
    return out;
  }

  std::vector<Vec2> ring(const Json& positions) const {
    if (!positions.is_array() || positions.size() < 4) {
      refuse({.says = "a ring must have at least 4 positions"});
    }
    std::vector<Vec2> out;
    for (const Json& position : positions) out.push_back(place(position));
    return out;
  }

  Vec2 place(const Json& position) const {
    if (!position.is_array() || position.size() < 2 || !position[0].is_number() ||
        !position[1].is_number()) {
      refuse({.key = "a position",
              .expected = "two or three numbers",
              .found = geom::shown(position)});
    }
    const Vec2 given(position[0].get<double>(), position[1].get<double>());
    const double most = local_ ? geom::kLargestCoordinate : 180;
    if (!(std::abs(given.x()) <= most && std::abs(given.y()) <= (local_ ? most : 90))) {
      refuse({.key = "a position",
              .expected = local_ ? "metres within 1e8" : "degrees [longitude, latitude]",
              .found = geom::shown(position)});
    }
    return local_ ? given : on_map(given);
  }

  Vec2 on_map(const Vec2& degrees) const {
    Vec3 enu = Vec3::Zero();
    earth_->from_geodetic(degrees.y(), degrees.x(), enu.x(), enu.y());
    if (!(enu.norm() <= kFar)) {
      refuse({.says = fmt::format("longitude {}, latitude {} is more than 1000 km from the map",
                                  degrees.x(), degrees.y()),
              .advice = "the order is longitude, latitude"});
    }
    return geom::to_enu(frame_.axes, enu).head<2>();
  }

  std::string source_;
  const geom::Frame& frame_;
  bool local_;
  std::unique_ptr<geom::GeographicFrame> earth_;  // unless local
  std::size_t number_ = 0;
  std::set<std::string> ids_;
  std::vector<DrawnSite> sites_;
};

}  // namespace

std::vector<DrawnSite> read_sites(std::istream& in, std::string_view source,
                                  const geom::Frame& frame, const SiteReading& reading) {
  return SiteReader(source, frame, reading).read(in);
}

}  // namespace traj
