#include "traj/home/rally_file.h"

#include <fmt/format.h>

#include <istream>
#include <nlohmann/json.hpp>

#include "geom/base/error.h"
#include "geom/map/geodetic_outline.h"
#include "geom/map/geographic_frame.h"
#include "geom/text/parse_json.h"

namespace traj {
namespace {

using Json = nlohmann::json;
using geom::Vec3;

class RallyReader {
 public:
  RallyReader(std::string_view source, const geom::Frame& frame)
      : source_(source), frame_(frame), earth_(*frame.origin) {}

  std::vector<Vec3> read(const Json& root) {
    take(root);
    if (places_.empty()) refuse({.expected = "at least one point", .found = "none"});
    return std::move(places_);
  }

 private:
  [[noreturn]] void refuse(geom::Fault fault) const {
    throw geom::InputError(source_, std::move(fault));
  }

  const Json& member(const Json& object, const char* key) const {
    if (object.is_object() && object.contains(key)) return object[key];
    refuse({.expected = geom::in_quotes(key), .found = geom::shown(object)});
  }

  // A collection, a feature or a point.
  void take(const Json& object) {
    const Json& type = member(object, "type");
    if (type == "FeatureCollection") {
      const Json& features = member(object, "features");
      if (!features.is_array()) refuse({.expected = "a list", .found = geom::shown(features)});
      for (const Json& feature : features) take_feature(feature);
    } else if (type == "Feature") {
      take_feature(object);
    } else {
      take_point(object);
    }
  }

  void take_feature(const Json& feature) {
    if (member(feature, "type") != "Feature") {
      refuse({.expected = "a feature", .found = geom::shown(feature)});
    }
    take_point(member(feature, "geometry"));
  }

  void take_point(const Json& geometry) {
    if (member(geometry, "type") != "Point") {
      refuse({.expected = "rally points: geometries of type Point",
              .found = geom::shown(member(geometry, "type"))});
    }
    const Json& numbers = member(geometry, "coordinates");
    if (!numbers.is_array() || numbers.size() != 3 || !numbers[0].is_number() ||
        !numbers[1].is_number() || !numbers[2].is_number()) {
      refuse({.expected = "longitude, latitude and metres above the ellipsoid",
              .found = geom::shown(numbers)});
    }
    const geom::GeodeticPlace place{numbers[1].get<double>(), numbers[0].get<double>(),
                                    numbers[2].get<double>()};
    if (!geom::is_near(*frame_.origin, place.latitude, place.longitude)) {
      refuse({.expected = fmt::format("a rally point near the origin {} {}",
                                      frame_.origin->latitude, frame_.origin->longitude),
              .found = fmt::format("{} {}", place.latitude, place.longitude)});
    }
    places_.push_back(geom::to_enu(frame_.axes, earth_.enu(place)));
  }

  std::string_view source_;
  const geom::Frame& frame_;
  geom::GeographicFrame earth_;
  std::vector<Vec3> places_;
};

}  // namespace

std::vector<Vec3> read_rally(std::istream& in, std::string_view source, const geom::Frame& frame) {
  if (!frame.origin) {
    throw geom::InputError(source, {.expected = "a map that knows where its origin is",
                                    .found = "none",
                                    .advice = "give --origin, or rally points as x,y,z"});
  }
  const Json root = geom::parse_json(in, source);
  return RallyReader(source, frame).read(root);
}

}  // namespace traj
