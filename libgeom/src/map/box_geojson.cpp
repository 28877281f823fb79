#include "geom/map/box_geojson.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <ostream>
#include <string>

#include "geom/base/error.h"
#include "geom/map/geographic_frame.h"
#include "geom/text/json_line.h"

namespace geom {
namespace {

// A ring around the box, closed, in east-north-up axes.
std::string ring(const GeographicFrame& earth, const Aabb& box) {
  const std::array<Vec3, 5> corners = {
      Vec3(box.min.x(), box.min.y(), 0), Vec3(box.max.x(), box.min.y(), 0),
      Vec3(box.max.x(), box.max.y(), 0), Vec3(box.min.x(), box.max.y(), 0),
      Vec3(box.min.x(), box.min.y(), 0)};
  std::string out;
  for (const Vec3& corner : corners) {
    const GeodeticPlace p = earth.place(corner);
    out += fmt::format("{}[{:.9f},{:.9f}]", out.empty() ? "" : ",", p.longitude, p.latitude);
  }
  return out;
}

std::string feature(const GeographicFrame& earth, const BoxMap& map, std::size_t i) {
  const Aabb box = to_enu(map.spec().frame.axes, map.boxes()[i]);
  JsonLine properties;
  properties.add("id", map.ids()[i]);
  const std::string& label = map.labels()[map.label()[i]];
  if (!label.empty()) properties.add("label", label);
  properties.add("base", box.min.z()).add("height", box.max.z() - box.min.z());
  const TimeSpan time = map.time(i);
  if (std::isfinite(time.from)) properties.add("from", time.from);
  if (std::isfinite(time.until)) properties.add("until", time.until);
  JsonLine geometry;
  geometry.add("type", "Polygon").add_json("coordinates", "[[" + ring(earth, box) + "]]");
  JsonLine line;
  line.add("type", "Feature").add("properties", properties).add("geometry", geometry);
  return line.object();
}

}  // namespace

void write_box_geojson(std::ostream& out, const BoxMap& map, std::string_view source) {
  const Frame& frame = map.spec().frame;
  if (!counts_from_origin(frame)) {
    throw InputError(source,
                     {.says = "the map does not say where on Earth it is",
                      .advice = "make it anew with an origin, or write its metres with to-csv"});
  }
  const GeographicFrame earth(*frame.origin);
  out << "{\"type\":\"FeatureCollection\",";
  if (map.spec().epoch) out << "\"epoch\":\"" << *map.spec().epoch << "\",";
  out << "\"features\":[\n";
  for (std::size_t i = 0; i < map.size(); ++i) {
    out << feature(earth, map, i) << (i + 1 < map.size() ? ",\n" : "\n");
  }
  out << "]}\n";
}

}  // namespace geom
