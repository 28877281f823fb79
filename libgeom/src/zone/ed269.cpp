#include "ed269.h"

#include <fmt/format.h>

#include "zone_period.h"

namespace geom::zone {
namespace {

const Json* zones_of(const Json& root) {
  if (root.is_array()) return &root;
  for (const char* key : {"features", "UASZoneList", "UASZoneVersions"}) {
    if (const Json* const list = member(root, key); list && list->is_array()) return list;
  }
  return nullptr;
}

// Metres in the unit of an airspace volume.
double unit_of(const Json& geometry, const ZonePlace& place) {
  const std::string unit = text_of(geometry, "uomDimensions");
  if (unit == "M" || unit == "m") return 1;
  if (unit == "FT" || unit == "ft") return 0.3048;
  place.refuse({.key = "uomDimensions",
                .expected = "M or FT",
                .found = unit.empty() ? std::string("none") : in_quotes(unit)});
}

class Reader {
 public:
  explicit Reader(const std::string& source) : source_(source) {}

  ZoneFile read(const Json& root) {
    out_.format = "ed-269";
    out_.title = text_of(root, "title");
    for (const char* key : {"createdAt", "issued", "creationDateTime"}) {
      if (!out_.issued && !text_of(root, key).empty()) out_.issued = text_of(root, key);
    }
    for (const Json& one : *zones_of(root)) add(one);
    return std::move(out_);
  }

 private:
  void add(const Json& json) {
    Zone zone;
    zone.identifier = text_of(json, "identifier");
    const ZonePlace place{
        source_, fmt::format("zone {}", zone.identifier.empty() ? fmt::to_string(out_.zones.size())
                                                                : in_quotes(zone.identifier))};
    if (zone.identifier.empty()) {
      place.refuse({.key = "identifier", .expected = "a text", .found = "none"});
    }
    zone.name = spoken(member(json, "name"));
    zone.country = text_of(json, "country");
    zone.type = type_of(member(json, "restriction"), "restriction", place);
    zone.authority = authorities_of(member(json, "zoneAuthority"));
    zone.message = message_of(json);
    zone.periods = periods_of(member(json, "applicability"), "applicability", place, out_.warnings);
    add_volumes(member(json, "geometry"), place, zone);
    out_.zones.push_back(std::move(zone));
  }

  void add_volumes(const Json* list, const ZonePlace& place, Zone& zone) {
    if (!list || !list->is_array() || list->empty()) {
      place.refuse({.key = "geometry",
                    .expected = "a list of airspace volumes",
                    .found = list ? shown(*list) : std::string("none")});
    }
    for (const Json& one : *list) {
      const Json* const shape = member(one, "horizontalProjection");
      if (!shape) {
        place.refuse(
            {.key = "horizontalProjection", .expected = "a Polygon or a Circle", .found = "none"});
      }
      const bool limited = member(one, "lowerLimit") || member(one, "upperLimit");
      const bool circle = text_of(*shape, "type") == "Circle";
      const double metres = limited || circle ? unit_of(one, place) : 1;
      for (ZoneVolume volume : shapes_of(*shape, metres, place)) {
        volume.lower = limit_of(one, {"lowerLimit", "lowerVerticalReference"}, metres, place);
        volume.upper = limit_of(one, {"upperLimit", "upperVerticalReference"}, metres, place);
        require_ordered(volume, place);
        zone.volumes.push_back(std::move(volume));
      }
    }
  }

  std::vector<ZoneVolume> shapes_of(const Json& shape, double metres, const ZonePlace& place) {
    if (text_of(shape, "type") != "Circle") return polygons_of(shape, place, out_.warnings);
    const Json* const centre = member(shape, "center");
    const Json* const radius = member(shape, "radius");
    if (!centre || !radius) {
      place.refuse({.key = "a Circle", .expected = "a center and a radius", .found = shown(shape)});
    }
    if (metres != 1) {
      out_.warnings.push_back(
          place.item +
          ": its limits are in feet, and its radius may be; it is read as metres, "
          "which is the larger");
    }
    return {circle_of(*centre, *radius, place)};
  }

  const std::string& source_;
  ZoneFile out_;
};

}  // namespace

bool is_ed269(const Json& root) {
  const Json* const list = zones_of(root);
  if (!list || list->empty() || text_of(root, "type") == "FeatureCollection") return false;
  const Json& first = list->front();
  return member(first, "restriction") || member(first, "applicability") ||
         (member(first, "geometry") && first["geometry"].is_array());
}

ZoneFile read_ed269(const Json& root, const std::string& source) {
  return Reader(source).read(root);
}

}  // namespace geom::zone
