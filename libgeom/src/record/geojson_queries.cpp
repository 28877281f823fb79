#include "geojson_queries.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "geom/base/error.h"
#include "geom/text/geojson_crs.h"
#include "geom/text/parse_json.h"
#include "read_flight_time.h"

namespace geom {
namespace {

using Json = nlohmann::json;

// The first of two points.
struct Begin {
  Vec3 place;
  FlightTime time;
};

class Features {
 public:
  Features(std::string_view source, const Locator& locator) : source_(source), locator_(locator) {}

  std::vector<PlanQuery> read(const Json& root) {
    require_wgs84(root);
    const Json& list =
        root.value("type", Json()) == "FeatureCollection" ? member(root, "features") : root;
    if (list.is_array()) {
      for (const Json& feature : list) add(feature);
    } else {
      add(list);
    }
    for (const auto& [id, start] : starts_) {
      throw InputError(
          source_, {.expected = fmt::format("a second point of id \"{}\"", id), .found = "one"});
    }
    if (queries_.empty())
      throw InputError(source_, {.expected = "at least one query", .found = "none"});
    return std::move(queries_);
  }

 private:
  [[noreturn]] void refuse(Fault fault) const {
    throw InputError(source_, within(fmt::format("feature {}", number_), std::move(fault)));
  }

  void require_wgs84(const Json& object) const {
    if (has_foreign_crs(object)) throw InputError(source_, foreign_crs());
  }

  const Json& member(const Json& object, const char* key) const {
    if (!object.is_object() || !object.contains(key)) {
      refuse({.expected = in_quotes(key), .found = "none"});
    }
    return object[key];
  }

  void add(const Json& feature) {
    ++number_;
    const Json& geometry = member(feature, "geometry");
    require_wgs84(feature);
    require_wgs84(geometry);
    const Json& coordinates = member(geometry, "coordinates");
    const Json& type = member(geometry, "type");
    if (type == "LineString") {
      if (!coordinates.is_array() || coordinates.size() < 2) {
        refuse({.says = "a line must have at least 2 positions"});
      }
      const std::string id = id_of(feature).value_or(fmt::format("q{}", number_));
      add_query(id, place(feature, coordinates.front()), place(feature, coordinates.back()),
                time_of(feature));
    } else if (type == "Point") {
      add_point(feature, coordinates);
    } else {
      refuse({.expected = "a LineString or a Point", .found = shown(type)});
    }
  }

  void add_point(const Json& feature, const Json& position) {
    const auto id = id_of(feature);
    if (!id) refuse({.expected = "an id, which the points of a query share", .found = "none"});
    const Vec3 here = place(feature, position);
    const auto start = starts_.find(*id);
    if (start == starts_.end()) {
      starts_.emplace(*id, Begin{here, time_of(feature)});
      return;
    }
    const FlightTime& said = start->second.time;
    add_query(*id, start->second.place, here, said.any() ? said : time_of(feature));
    starts_.erase(start);
  }

  void add_query(const std::string& id, const Vec3& from, const Vec3& to, const FlightTime& time) {
    queries_.push_back({id, from, to, {}, 0, true, true, time});
  }

  // By its properties.
  FlightTime time_of(const Json& feature) const {
    const Json properties = feature.value("properties", Json());
    if (!properties.is_object()) return {};
    return flight_time_of(properties, [this](Fault fault) { refuse(std::move(fault)); });
  }

  std::optional<std::string> id_of(const Json& feature) const {
    const Json properties = feature.value("properties", Json());
    const auto text = [](const Json& object, const char* key) -> std::optional<std::string> {
      if (!object.is_object() || !object.contains(key)) return std::nullopt;
      if (object[key].is_string()) return object[key].get<std::string>();
      return object[key].is_number() ? std::optional(object[key].dump()) : std::nullopt;
    };
    if (auto id = text(feature, "id")) return id;
    if (auto id = text(properties, "id")) return id;
    return text(properties, "name");
  }

  Vec3 place(const Json& feature, const Json& position) const {
    if (!position.is_array() || position.size() < 2 || !position[0].is_number() ||
        !position[1].is_number()) {
      refuse({.key = "a position",
              .expected = "[longitude, latitude, height]",
              .found = shown(position)});
    }
    EarthPlace there{position[1].get<double>(), position[0].get<double>()};
    if (!(std::abs(there.latitude) <= 90 && std::abs(there.longitude) <= 180)) {
      refuse({.key = "a position",
              .expected = "degrees [longitude, latitude]",
              .found = fmt::format("[{}, {}]", there.longitude, there.latitude)});
    }
    const Height height = height_of(feature, position);
    there.height = height.metres;
    there.above = height.above;
    return locator_.at(there, source_, 0);
  }

  // Of a third coordinate, less the map's zero, and the property height.
  void require_same_height(const Json& third, const Json& said) const {
    constexpr double kSame = 1e-6;  // metres
    if (said.is_null()) return;
    const bool numbers = third.is_number() && said.is_number();
    if (numbers && std::abs(third.get<double>() - said.get<double>()) <= kSame) return;
    refuse({.expected = "one height above the map's zero",
            .found = fmt::format("{} by the third coordinate and {} by the property height",
                                 shown(third), shown(said)),
            .advice = "leave one of them out"});
  }

  Height height_of(const Json& feature, const Json& position) const {
    const Json properties = feature.value("properties", Json());
    const Json said = properties.is_object() ? properties.value("height", Json()) : Json();
    Json value = said;
    if (position.size() > 2) {
      value = position[2];
      if (value.is_number()) value = value.get<double>() - locator_.zero();
      require_same_height(value, said);
    }
    if (value.is_number() && std::abs(value.get<double>()) <= kLargestCoordinate) {
      return {value.get<double>()};
    }
    if (value.is_string()) {
      if (const auto height = parse_height(value.get<std::string>())) return *height;
    }
    refuse({.expected = "a height, as third coordinate or as property height, in metres or such as "
                        "\"2above\"",
            .found = value.is_null() ? "none" : shown(value)});
  }

  std::string source_;
  const Locator& locator_;
  std::size_t number_ = 0;
  std::vector<PlanQuery> queries_;
  std::map<std::string, Begin> starts_;  // of points whose second is to come
};

}  // namespace

bool looks_like_geojson(std::string_view text) {
  const auto has = [&](std::string_view word) { return text.find(word) != text.npos; };
  return text == "{" || ((has("\"FeatureCollection\"") || has("\"Feature\"")) && !has("\"from\""));
}

std::vector<PlanQuery> geojson_queries(const Json& root, std::string_view source,
                                       const Locator& locator) {
  return Features(source, locator).read(root);
}

}  // namespace geom
