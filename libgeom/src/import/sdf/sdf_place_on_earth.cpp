#include "sdf_place_on_earth.h"

#include <fmt/format.h>

#include <cmath>

namespace geom {
namespace {

std::optional<SdfNode> map_of(const SdfNode& world) {
  for (const XmlElement& child : world.element->children) {
    if (child.prefix == "skyway" && child.name == "map") return world.of(child);
  }
  return std::nullopt;
}

// In an attribute of <skyway:map>.
std::vector<double> numbers_of(const SdfNode& map, const char* key, std::size_t count) {
  XmlElement words;
  words.name = key;
  words.line = map.element->line;
  words.text = map.attribute(key);
  return SdfNode{&words, map.source}.numbers(count);
}

void require_text(const SdfNode& place, const char* key, std::string_view expected) {
  const auto found = place.find(key);
  if (!found || found->text() == expected) return;
  found->refuse({.key = fmt::format("<{}>", key),
                 .expected = std::string(expected),
                 .found = in_quotes(found->text().substr(0, 40))});
}

double degrees(const SdfNode& place, const char* key, double most) {
  const SdfNode found = place.child(key);
  const double value = found.numbers(1)[0];
  if (!(std::abs(value) <= most)) {
    found.refuse({.key = fmt::format("<{}>", key),
                  .expected = fmt::format("within {}", most),
                  .found = fmt::to_string(value)});
  }
  return value;
}

}  // namespace

Frame frame_of(const SdfNode& world) {
  Frame frame;
  if (const auto map = map_of(world)) {
    frame.crs = map->attribute("crs");
    if (!map->attribute("origin").empty()) {
      const std::vector<double> v = numbers_of(*map, "origin", 3);
      if (std::abs(v[0]) > 90 || std::abs(v[1]) > 180) {
        map->refuse({.key = "origin",
                     .expected = "a latitude, a longitude and a height",
                     .found = "another"});
      }
      frame.origin = {v[0], v[1], v[2]};
    }
  }
  const auto place = world.find("spherical_coordinates");
  if (!place) return frame;
  require_text(*place, "surface_model", "EARTH_WGS84");
  require_text(*place, "world_frame_orientation", "ENU");
  if (const auto heading = place->find("heading_deg")) {
    const double turn = heading->numbers(1)[0];
    if (turn != 0) {
      heading->refuse({.key = "<heading_deg>",
                       .expected = "0",
                       .found = fmt::to_string(turn),
                       .advice = "simulators differ in which way it turns a world"});
    }
  }
  GeodeticOrigin origin;
  origin.latitude = degrees(*place, "latitude_deg", 90);
  origin.longitude = degrees(*place, "longitude_deg", 180);
  if (const auto height = place->find("elevation")) origin.height = height->numbers(1)[0];
  frame.origin = origin;
  return frame;
}

std::optional<Aabb> bounds_of(const SdfNode& world) {
  const auto map = map_of(world);
  if (!map || map->attribute("bounds").empty()) return std::nullopt;
  const std::vector<double> v = numbers_of(*map, "bounds", 6);
  const Aabb bounds{{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
  if ((bounds.min.array() > bounds.max.array()).any()) {
    map->refuse({.says = "bounds must have their lower corner first", .found = "another"});
  }
  return bounds;
}

}  // namespace geom
