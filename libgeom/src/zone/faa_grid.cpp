#include "faa_grid.h"

#include <fmt/format.h>

#include <algorithm>

#include "geom/text/geojson_crs.h"

namespace geom::zone {
namespace {

constexpr double kFoot = 0.3048;
constexpr double kHighest = 10000;  // ft, that a ceiling may be

std::string identifier_of(const Json& properties, std::size_t index) {
  const std::string airport = text_of(properties, "APT1_ICAO");
  const Json* const object = member(properties, "OBJECTID");
  return fmt::format("{}/{}", airport.empty() ? std::string("UASFM") : airport,
                     object && object->is_number() ? object->dump() : fmt::to_string(index));
}

// Who decides. The FAA's UNIT is the unit of the ceiling; copies have the facility there, with a
// blank in its name.
std::string authority_of(const Json& properties, const ZonePlace& place) {
  const Json* const value = member(properties, "UNIT");
  const std::string unit = text_of(properties, "UNIT");
  if (unit.find(' ') != std::string::npos) return "FAA, " + unit;
  if (value && unit != "Feet" && unit != "FEET" && unit != "feet" && unit != "ft") {
    place.refuse({.key = "UNIT", .expected = "Feet", .found = shown(*value)});
  }
  return "FAA";
}

double ceiling_of(const Json& properties, const ZonePlace& place) {
  const Json* const value = member(properties, "CEILING");
  if (!value) place.refuse({.key = "CEILING", .expected = "feet", .found = "none"});
  const double feet = number_of(*value, "CEILING", place);
  if (!(feet >= 0 && feet <= kHighest)) {
    place.refuse({.key = "CEILING", .expected = "0 to 10000 feet", .found = shown(*value)});
  }
  return feet;
}

void add_cell(const Json& feature, const std::string& source, ZoneFile& out) {
  const Json* const properties = member(feature, "properties");
  const Json* const geometry = member(feature, "geometry");
  const std::size_t index = out.zones.size();
  const std::string identifier = properties ? identifier_of(*properties, index) : "";
  const ZonePlace place{source, fmt::format("cell {}", identifier)};
  if (!properties || !geometry) {
    place.refuse({.expected = "properties and a geometry", .found = shown(feature)});
  }
  if (has_foreign_crs(feature)) throw InputError(source, foreign_crs());
  const double feet = ceiling_of(*properties, place);
  Zone low;
  low.identifier = identifier;
  low.name = text_of(*properties, "APT1_NAME");
  low.country = "USA";
  low.type = ZoneType::authorization;
  low.authority = authority_of(*properties, place);
  low.message =
      fmt::format("up to {} ft above the ground a flight may be authorized (LAANC)", feet);
  low.volumes = polygons_of(*geometry, place, out.warnings);
  Zone high = low;
  high.type = ZoneType::prohibited;
  high.message =
      fmt::format("above {} ft no flight is authorized without further coordination", feet);
  for (ZoneVolume& volume : low.volumes) {
    volume.upper = HeightLimit{feet * kFoot, HeightReference::ground};
  }
  for (ZoneVolume& volume : high.volumes) {
    if (feet > 0) volume.lower = HeightLimit{feet * kFoot, HeightReference::ground};
  }
  if (feet > 0) out.zones.push_back(std::move(low));
  out.zones.push_back(std::move(high));
  const std::string effective = text_of(*properties, "MAP_EFF");
  if (!effective.empty()) out.issued = std::max(out.issued.value_or(""), effective);
}

}  // namespace

bool is_faa_grid(const Json& root) {
  const Json* const features = member(root, "features");
  if (text_of(root, "type") != "FeatureCollection" || !features || !features->is_array() ||
      features->empty()) {
    return false;
  }
  const Json* const properties = member(features->front(), "properties");
  return properties && properties->contains("CEILING");
}

ZoneFile read_faa_grid(const Json& root, const std::string& source) {
  if (has_foreign_crs(root)) throw InputError(source, foreign_crs());
  ZoneFile out;
  out.format = "faa-uasfm";
  for (const Json& feature : root["features"]) add_cell(feature, source, out);
  return out;
}

}  // namespace geom::zone
