#include "geom/import/keep_out.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <istream>
#include <nlohmann/json.hpp>
#include <set>

#include "geom/base/error.h"
#include "geom/map/geographic_frame.h"
#include "geom/text/geojson_crs.h"
#include "geom/text/instant.h"
#include "geom/text/parse_json.h"

namespace geom {
namespace {

using Json = nlohmann::json;

std::string lower_case(std::string word) {
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return word;
}

class Reader {
 public:
  Reader(std::string_view source, const Frame& frame, const KeepOutOptions& options)
      : source_(source), frame_(frame), options_(options) {
    if (!options.local && !counts_from_origin(frame)) {
      refuse({.says =
                  "the map has no origin on Earth, so longitudes and latitudes have no place on it",
              .advice = "give coordinates in the map's metres, with --keep-out-local"});
    }
    if (!options.local) geographic_ = std::make_unique<GeographicFrame>(*frame.origin);
  }

  KeepOut read(std::istream& in) {
    const Json root = parse_json(in, source_);
    if (!root.is_object()) refuse({.expected = "a GeoJSON object", .found = "another value"});
    require_wgs84(root);
    require_epoch(root);
    const std::string type = root.value("type", Json()).dump();
    if (root.contains("features") && type != "\"FeatureCollection\"") {
      throw InputError(source_, {.expected = "\"type\":\"FeatureCollection\" beside \"features\"",
                                 .found = std::string(type.substr(0, 40)),
                                 .advice = "zones of ED-269 are read by --zones"});
    }
    if (type == "\"FeatureCollection\"") {
      const Json features = root.value("features", Json());
      if (!features.is_array())
        refuse({.expected = "\"features\" to be a list", .found = "another value"});
      for (const Json& feature : features) read_feature(feature);
    } else {
      read_feature(type == "\"Feature\"" ? root : Json{{"geometry", root}});
    }
    if (out_.volumes.empty()) refuse({.expected = "at least one polygon", .found = "none"});
    return std::move(out_);
  }

 private:
  [[noreturn]] void refuse(Fault fault) const {
    throw InputError(source_, within(fmt::format("feature {}", feature_), std::move(fault)));
  }

  void require_wgs84(const Json& object) const {
    if (!options_.local && has_foreign_crs(object)) throw InputError(source_, foreign_crs());
  }

  void require_epoch(const Json& object) const {
    if (!object.contains("epoch") || object["epoch"].is_null()) return;
    const Json& value = object["epoch"];
    if (!options_.epoch || !value.is_string() ||
        epoch_from(value.get<std::string>()) != options_.epoch) {
      throw InputError(source_, {.expected = fmt::format("the epoch of the map, {}",
                                                         options_.epoch.value_or("which has none")),
                                 .found = shown(value)});
    }
  }

  void read_feature(const Json& feature) {
    const Json properties =
        feature.is_object() ? feature.value("properties", Json::object()) : Json();
    const Json geometry = feature.is_object() ? feature.value("geometry", Json()) : Json();
    if (!geometry.is_object()) refuse({.expected = "a feature with a geometry", .found = "none"});
    require_wgs84(feature);
    require_wgs84(geometry);
    if (properties.contains("from") || properties.contains("until")) {
      for (const Json* object : {&feature, &properties, &geometry}) require_epoch(*object);
    }
    note_unread(feature, properties, geometry);
    Footprint volume;
    volume.id = feature_;
    const auto lower = altitude(properties, {"lower", "lower_altitude_m"});
    const auto upper = altitude(properties, {"upper", "upper_altitude_m"});
    volume.bottom = lower.value_or(options_.floor);
    volume.top = upper.value_or(options_.ceiling);
    out_.open_below = out_.open_below || !lower;
    out_.open_above = out_.open_above || !upper;
    if (volume.bottom > volume.top) {
      refuse({.key = "the lower altitude",
              .expected = "<= the upper one",
              .found = fmt::format("{} and {}", volume.bottom, volume.top)});
    }
    time_ = {end_of(properties, "from").first, end_of(properties, "until").second};
    if (const auto fault = span_fault(time_)) refuse(*fault);
    const Json name = properties.is_object() ? properties.value("name", Json()) : Json();
    label_ = "keep-out" + (name.is_string() ? ": " + name.get<std::string>() : std::string());
    const std::string type = geometry.value("type", Json()).dump();
    const Json coordinates = geometry.value("coordinates", Json());
    if (type == "\"Polygon\"") {
      add(coordinates, volume);
    } else if (type == "\"MultiPolygon\"" && coordinates.is_array()) {
      for (const Json& polygon : coordinates) add(polygon, volume);
    } else {
      refuse({.expected = "a Polygon or a MultiPolygon", .found = type.substr(0, 40)});
    }
    ++feature_;
  }

  // Where it is between, in seconds after the epoch; all times where nothing is said.
  std::pair<double, double> end_of(const Json& properties, const char* key) const {
    if (!properties.is_object() || !properties.contains(key) || properties[key].is_null()) {
      return {TimeSpan{}.from, TimeSpan{}.until};
    }
    const Json& value = properties[key];
    if (!options_.epoch) {
      refuse({.says = fmt::format("{} counts from an epoch, and the map has none", key),
              .advice = "give --epoch"});
    }
    if (value.is_number()) return {value.get<double>(), value.get<double>()};
    const auto instant =
        value.is_string() ? epoch_from(value.get<std::string>()) : std::optional<std::string>();
    if (!instant) {
      refuse({.key = std::string(key),
              .expected = "seconds after the epoch, or an instant in UTC such as "
                          "\"2026-05-04T06:30:00Z\" (RFC 3339)",
              .found = shown(value)});
    }
    const SecondsBetween after = seconds_between(*options_.epoch, *instant);
    return {after.least, after.most};
  }

  std::optional<double> altitude(const Json& properties,
                                 std::initializer_list<const char*> keys) const {
    std::optional<double> said;
    for (const char* key : keys) {
      if (!properties.is_object() || !properties.contains(key) || properties[key].is_null())
        continue;
      const Json& value = properties[key];
      if (!value.is_number() || !(std::abs(value.get<double>()) <= kLargestCoordinate)) {
        refuse({.key = std::string(key), .expected = "metres", .found = shown(value)});
      }
      if (said.value_or(value.get<double>()) != value.get<double>()) {
        refuse({.key = std::string(key),
                .expected = fmt::format("{}, as {} is", *said, *keys.begin()),
                .found = shown(value)});
      }
      said = value.get<double>();
    }
    if (said) require_no_unit(properties);
    return said;
  }

  // Beside an altitude.
  void require_no_unit(const Json& properties) const {
    for (const auto& [key, value] : properties.items()) {
      const std::string word = lower_case(key);
      const bool unit = word == "uom" || word == "unit" || word == "units" ||
                        word == "uomdimensions" || word.ends_with("reference") ||
                        word.ends_with("datum");
      if (!unit || value.is_null()) continue;
      refuse({.key = "lower and upper",
              .expected = "metres in the map's z",
              .found = fmt::format("\"{}\" beside them", key.substr(0, 40)),
              .advice = "convert them, and leave it out"});
    }
  }

  // Counts the names of each feature once.
  void note_unread(const Json& feature, const Json& properties, const Json& geometry) {
    std::set<std::string> names;
    for (const Json* object : {&feature, &properties, &geometry}) {
      if (!object->is_object()) continue;
      for (const auto& [key, value] : object->items()) {
        if (!value.is_null() && may_limit(lower_case(key))) names.insert(key.substr(0, 40));
      }
    }
    for (const std::string& name : names) ++out_.unread[name];
  }

  // Whether what is so called may say how high, or when, a volume is there.
  static bool may_limit(const std::string& word) {
    for (const char* read : {"lower", "lower_altitude_m", "upper", "upper_altitude_m"}) {
      if (word == read) return false;
    }
    for (const char* part : {"altitude", "lower", "upper", "floor", "ceiling", "height", "limit",
                             "layer", "applicab"}) {
      if (word.find(part) != std::string::npos) return true;
    }
    return false;
  }

  void add(const Json& rings, Footprint volume) {
    if (!rings.is_array() || rings.empty()) refuse({.says = "a polygon must have rings"});
    double bulge = 0;
    volume.polygon.outer = ring(rings[0], bulge);
    for (std::size_t i = 1; i < rings.size(); ++i) {
      volume.polygon.holes.push_back(ring(rings[i], bulge));
    }
    out_.volumes.push_back(std::move(volume));
    out_.labels.push_back(label_);
    out_.bulge.push_back(bulge);
    out_.times.push_back(time_);
  }

  std::vector<Vec2> ring(const Json& positions, double& bulge) const {
    if (!positions.is_array() || positions.size() < 4) {
      refuse({.says = "a ring must have at least 4 positions"});
    }
    std::vector<Vec2> given;
    for (const Json& position : positions) {
      if (!position.is_array() || position.size() < 2 || !position[0].is_number() ||
          !position[1].is_number()) {
        refuse({.key = "a position", .expected = "two numbers", .found = shown(position)});
      }
      given.push_back(checked(position[0].get<double>(), position[1].get<double>()));
    }
    if (options_.local) return given;
    std::vector<Vec2> out;
    for (std::size_t i = 0; i < given.size(); ++i) {
      follow(given[i], given[(i + 1) % given.size()], out, bulge);
    }
    return out;
  }

  // Appends the edge from `a` to `b` (degrees) in metres, without its end.
  void follow(const Vec2& a, const Vec2& b, std::vector<Vec2>& out, double& bulge) const {
    const double length = (local(b) - local(a)).norm();
    const double pieces = std::clamp(std::ceil(length / 200), 1.0, 1000.0);
    for (double i = 0; i < pieces; ++i) out.push_back(local(a + (b - a) * (i / pieces)));
    // A chord of a curve bent by k a metre leaves out k length^2 / 8. Parallels are bent most.
    const double steepest = std::min(89.0, std::max(std::abs(a.y()), std::abs(b.y())));
    const double bent = (1 + std::tan(steepest * (M_PI / 180))) / 6.3e6;
    bulge = std::max(bulge, bent * (length / pieces) * (length / pieces) / 8);
  }

  Vec2 checked(double x, double y) const {
    const double most = options_.local ? kLargestCoordinate : 180;
    if (!(std::abs(x) <= most && std::abs(y) <= (options_.local ? most : 90))) {
      refuse({.key = "a position",
              .expected = options_.local ? "metres within 1e8" : "degrees [longitude, latitude]",
              .found = fmt::format("[{}, {}]", x, y)});
    }
    return {x, y};
  }

  Vec2 local(const Vec2& degrees) const {
    Vec3 enu = Vec3::Zero();
    geographic_->from_geodetic(degrees.y(), degrees.x(), enu.x(), enu.y());
    return to_enu(frame_.axes, enu).head<2>();
  }

  std::string source_;
  const Frame& frame_;
  KeepOutOptions options_;
  std::unique_ptr<GeographicFrame> geographic_;  // unless local
  std::size_t feature_ = 0;
  std::string label_;
  TimeSpan time_;
  KeepOut out_;
};

}  // namespace

KeepOut read_keep_out(std::istream& in, std::string_view source, const Frame& frame,
                      const KeepOutOptions& options) {
  return Reader(source, frame, options).read(in);
}

}  // namespace geom
