#include <fmt/format.h>

#include "geom/map/geographic_frame.h"
#include "geom/map/label_colour.h"
#include "layers.h"

namespace view {
namespace {

// Of each label the colour that it is, as "#ff0000", or null.
Json written_colours(const std::vector<std::string>& labels) {
  Json out = Json::array();
  for (const std::string& label : labels) {
    const auto c = geom::written_colour(label);
    out.push_back(c ? Json(fmt::format("#{:02x}{:02x}{:02x}", (*c)[0], (*c)[1], (*c)[2])) : Json());
  }
  return out;
}

// Latitude and longitude as polynomials of the second degree in (east, north), from the middle of
// the bounds, in units of half their size: exact there, at the ends of both axes and in a corner.
Json geographic_layer(const geom::GeodeticOrigin& origin, const geom::Aabb& bounds) {
  const geom::GeographicFrame earth(origin);
  const geom::Vec3 middle = 0.5 * (bounds.min + bounds.max);
  const double scale = 0.5 * (bounds.max - bounds.min).head<2>().maxCoeff();
  const auto at = [&](double x, double y) {
    geom::GeodeticPlace place;
    earth.to_geodetic(middle.x() + x * scale, middle.y() + y * scale, place.latitude,
                      place.longitude);
    return place;
  };
  const auto coefficients = [&](double geom::GeodeticPlace::*of) {
    const double c = at(0, 0).*of;
    const double east = at(1, 0).*of;
    const double west = at(-1, 0).*of;
    const double north = at(0, 1).*of;
    const double south = at(0, -1).*of;
    const double xx = 0.5 * (east + west) - c;
    const double yy = 0.5 * (north + south) - c;
    const double x = 0.5 * (east - west);
    const double y = 0.5 * (north - south);
    return Json{c, x, y, xx, at(1, 1).*of - c - x - y - xx - yy, yy};
  };
  return {{"at", {middle.x(), middle.y()}},
          {"scale", scale},
          {"latitude", coefficients(&geom::GeodeticPlace::latitude)},
          {"longitude", coefficients(&geom::GeodeticPlace::longitude)}};
}

}  // namespace

Json map_layer(const geom::BoxMap& map, const LocalFrame& frame, Bundle& bundle) {
  const geom::BoxMapSpec& spec = map.spec();
  const geom::Axes axes = spec.frame.axes;
  const geom::Aabb bounds = geom::to_enu(axes, spec.bounds);
  Json out = {{"hash", map.hash()},         {"boxes", map.size()},
              {"frame", geom::name(axes)},  {"min", as_json(bounds.min)},
              {"max", as_json(bounds.max)}, {"bounds_from", spec.bounds_from},
              {"labels", map.labels()},     {"colours", written_colours(map.labels())}};
  out.update(box_layer(map, frame, bundle));
  if (!map.timed().empty()) out["timed"] = map.timed().size();
  if (spec.frame.origin) {
    out["latitude"] = spec.frame.origin->latitude;
    out["longitude"] = spec.frame.origin->longitude;
  }
  if (geom::counts_from_origin(spec.frame)) {
    out["geographic"] = geographic_layer(*spec.frame.origin, bounds);
  }
  if (!spec.frame.crs.empty()) out["crs"] = spec.frame.crs;
  return out;
}

}  // namespace view
