#include "ed318.h"

#include <fmt/format.h>

#include "geom/text/geojson_crs.h"
#include "zone_period.h"

namespace geom::zone {
namespace {

double unit_of(const Json& layer, const ZonePlace& place) {
  const Json* const unit = member(layer, "uom");
  if (!unit || *unit == "m" || *unit == "M") return 1;
  if (*unit == "ft" || *unit == "FT") return 0.3048;
  place.refuse({.key = "uom", .expected = "m or ft", .found = shown(*unit)});
}

class Reader {
 public:
  explicit Reader(const std::string& source) : source_(source) {}

  ZoneFile read(const Json& root) {
    out_.format = "ed-318";
    out_.title = text_of(root, out_title(root));
    read_metadata(member(root, "metadata"));
    refuse_foreign_crs(root);
    for (const Json& feature : root["features"]) add(feature);
    return std::move(out_);
  }

 private:
  static const char* out_title(const Json& root) {
    return member(root, "name") ? "name" : member(root, "title") ? "title" : "description";
  }

  void refuse_foreign_crs(const Json& object) const {
    if (object.is_object() && has_foreign_crs(object)) throw InputError(source_, foreign_crs());
  }

  void read_metadata(const Json* metadata) {
    if (!metadata) return;
    const ZonePlace place{source_, "metadata"};
    if (const Json* const at = member(*metadata, "issued")) {
      out_.issued = instant_of(*at, "issued", Side::begin, place);
    }
    if (const Json* const at = member(*metadata, "validFrom")) {
      out_.valid_from = instant_of(*at, "validFrom", Side::begin, place);
    }
    if (const Json* const at = member(*metadata, "validTo")) {
      out_.valid_to = instant_of(*at, "validTo", Side::end, place);
    }
    if (const Json* const geoid = member(*metadata, "otherGeoid")) {
      out_.warnings.push_back(fmt::format(
          "heights above the sea count from the geoid {}, which may be a metre from EGM2008",
          shown(*geoid)));
    }
  }

  void add(const Json& feature) {
    const Json* const properties = member(feature, "properties");
    Zone zone;
    if (properties) zone.identifier = text_of(*properties, "identifier");
    const ZonePlace place{
        source_, fmt::format("zone {}", zone.identifier.empty() ? fmt::to_string(out_.zones.size())
                                                                : in_quotes(zone.identifier))};
    if (zone.identifier.empty()) {
      place.refuse({.key = "identifier", .expected = "a text", .found = "none"});
    }
    refuse_foreign_crs(feature);
    zone.name = spoken(member(*properties, "name"));
    zone.country = text_of(*properties, "country");
    zone.type = type_of(member(*properties, "type"), "type", place);
    zone.authority = authorities_of(member(*properties, "zoneAuthority"));
    zone.message = message_of(*properties);
    zone.periods = periods_of(member(*properties, "limitedApplicability"), "limitedApplicability",
                              place, out_.warnings);
    const Json* const geometry = member(feature, "geometry");
    if (!geometry) place.refuse({.key = "geometry", .expected = "an object", .found = "none"});
    const Json* layer = member(feature, "layer");
    if (!layer) layer = member(*properties, "layer");
    add_volumes(*geometry, layer, place, zone);
    out_.zones.push_back(std::move(zone));
  }

  // A geometry without layer has that of the collection around it, or of the feature.
  void add_volumes(const Json& geometry, const Json* layer, const ZonePlace& place, Zone& zone) {
    if (const Json* const own = member(geometry, "layer")) layer = own;
    if (text_of(geometry, "type") == "GeometryCollection") {
      const Json* const list = member(geometry, "geometries");
      if (!list || !list->is_array() || list->empty()) {
        place.refuse({.key = "geometries", .expected = "a list", .found = shown(geometry)});
      }
      for (const Json& one : *list) add_volumes(one, layer, place, zone);
      return;
    }
    refuse_foreign_crs(geometry);
    for (ZoneVolume volume : shapes_of(geometry, place)) {
      if (layer) {
        const double metres = unit_of(*layer, place);
        volume.lower = limit_of(*layer, {"lower", "lowerReference"}, metres, place);
        volume.upper = limit_of(*layer, {"upper", "upperReference"}, metres, place);
        require_ordered(volume, place);
      }
      zone.volumes.push_back(std::move(volume));
    }
  }

  std::vector<ZoneVolume> shapes_of(const Json& geometry, const ZonePlace& place) {
    if (text_of(geometry, "type") != "Point") return polygons_of(geometry, place, out_.warnings);
    const Json* const extent = member(geometry, "extent");
    const Json* const radius = extent ? member(*extent, "radius") : nullptr;
    const Json* const centre = member(geometry, "coordinates");
    if (!radius || !centre || text_of(*extent, "subType") != "Circle") {
      place.refuse({.key = "a Point",
                    .expected = "an extent with \"subType\":\"Circle\" and a radius",
                    .found = extent ? shown(*extent) : std::string("none")});
    }
    return {circle_of(*centre, *radius, place)};
  }

  const std::string& source_;
  ZoneFile out_;
};

}  // namespace

bool is_ed318(const Json& root) {
  const Json* const features = member(root, "features");
  if (text_of(root, "type") != "FeatureCollection" || !features || !features->is_array() ||
      features->empty()) {
    return false;
  }
  const Json* const properties = member(features->front(), "properties");
  if (!properties) return false;
  for (const char* key : {"variant", "zoneAuthority", "limitedApplicability", "identifier"}) {
    if (member(*properties, key)) return true;
  }
  return false;
}

ZoneFile read_ed318(const Json& root, const std::string& source) {
  return Reader(source).read(root);
}

}  // namespace geom::zone
