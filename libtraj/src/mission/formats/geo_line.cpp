#include "traj/mission/formats/geo_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <istream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <ostream>

#include "geom/base/error.h"
#include "geom/text/geojson_crs.h"
#include "geom/text/json_line.h"
#include "geom/text/markup.h"
#include "geom/text/parse_json.h"
#include "mission/dji/xml_element.h"

namespace traj {
namespace {

using Json = nlohmann::ordered_json;
using geom::shown;

std::string coordinates(const geom::GeodeticPlace& p) {
  return fmt::format("{:.9f},{:.9f},{:.4f}", p.longitude, p.latitude, p.height);
}

bool is_place(double longitude, double latitude, double height) {
  return std::abs(longitude) <= 180 && std::abs(latitude) <= 90 &&
         std::abs(height) <= geom::kLargestCoordinate;
}

std::string all_of(std::istream& in) { return {std::istreambuf_iterator<char>(in), {}}; }

// --- KML ------------------------------------------------------------------------------------

class KmlReader {
 public:
  explicit KmlReader(std::string_view source) : source_(source) {}

  std::vector<GeoPoints> lines(const XmlElement& root) {
    if (root.name != "kml")
      refuse(root, {.expected = "KML", .found = fmt::format("<{}>", shown(root))});
    take(root);
    if (lines_.empty())
      throw geom::InputError(source_, {.expected = "a LineString", .found = "none"});
    return std::move(lines_);
  }

 private:
  [[noreturn]] void refuse(const XmlElement& element, geom::Fault fault) const {
    throw geom::InputError(source_, element.line, std::move(fault));
  }

  static std::string shown(const XmlElement& element) { return element.name.substr(0, 60); }

  template <std::size_t N>
  static bool is_one_of(const XmlElement& element, const std::array<const char*, N>& names) {
    return std::find(names.begin(), names.end(), element.name) != names.end();
  }

  void take(const XmlElement& element) {
    // What has no place of its own.
    static constexpr std::array kAside = {
        "name",    "visibility",    "open",           "author",           "link",
        "address", "phoneNumber",   "Snippet",        "snippet",          "description",
        "LookAt",  "Camera",        "TimeStamp",      "TimeSpan",         "styleUrl",
        "Style",   "StyleMap",      "Region",         "ExtendedData",     "Metadata",
        "Schema",  "ScreenOverlay", "AddressDetails", "balloonVisibility"};
    static constexpr std::array kHolders = {"kml", "Document", "Folder", "Placemark",
                                            "MultiGeometry"};
    if (element.name == "LineString") return take_line(element);
    if (is_one_of(element, kHolders)) {
      for (const XmlElement& child : element.children) take(child);
    } else if (!is_one_of(element, kAside)) {
      refuse(element,
             {.expected = "LineStrings",
              .found = fmt::format("<{}>, which is no line that could be flown", shown(element)),
              .advice = "remove it"});
    }
  }

  // The one child of that name; nothing where there is none.
  const XmlElement* child_of(const XmlElement& line, std::string_view name) const {
    const XmlElement* found = nullptr;
    for (const XmlElement& child : line.children) {
      if (child.name != name) continue;
      if (found)
        refuse(child, {.expected = fmt::format("one <{}> in a LineString", name), .found = "two"});
      found = &child;
    }
    return found;
  }

  void take_line(const XmlElement& line) {
    static constexpr std::array kKnown = {"extrude", "tessellate", "altitudeMode", "coordinates",
                                          "drawOrder"};
    for (const XmlElement& child : line.children) {
      if (!is_one_of(child, kKnown) || !child.children.empty()) {
        refuse(child, {.expected = "a LineString with altitudeMode and coordinates",
                       .found = fmt::format("<{}>", shown(child))});
      }
    }
    require_absolute(line);
    const XmlElement* const coordinates = child_of(line, "coordinates");
    if (!coordinates) refuse(line, {.expected = "a LineString with coordinates", .found = "none"});
    lines_.push_back(points(*coordinates));
  }

  void require_absolute(const XmlElement& line) const {
    const XmlElement* const mode = child_of(line, "altitudeMode");
    if (!mode) {
      refuse(line, {.expected = "altitudeMode absolute",
                    .found = "none, which means on the ground",
                    .advice = "give heights above the sea and say so"});
    }
    std::string_view said = mode->text;
    said.remove_prefix(std::min(said.find_first_not_of(kSpace), said.size()));
    said = said.substr(0, said.find_last_not_of(kSpace) + 1);
    if (said == "absolute") return;
    refuse(*mode, {.key = "altitudeMode",
                   .expected = "absolute (above the sea), as the ground is not in the file",
                   .found = geom::in_quotes(said.substr(0, 60))});
  }

  GeoPoints points(const XmlElement& coordinates) const {
    GeoPoints points;
    std::string_view rest = coordinates.text;
    while (true) {
      rest.remove_prefix(std::min(rest.find_first_not_of(kSpace), rest.size()));
      if (rest.empty()) break;
      const std::size_t stop = std::min(rest.find_first_of(kSpace), rest.size());
      points.push_back(point(rest.substr(0, stop), coordinates));
      rest.remove_prefix(stop);
    }
    if (points.empty()) refuse(coordinates, {.expected = "coordinates", .found = "none"});
    return points;
  }

  geom::GeodeticPlace point(std::string_view text, const XmlElement& coordinates) const {
    double value[3];
    const char* at = text.data();
    const char* const end = at + text.size();
    for (int i = 0; i < 3; ++i) {
      const auto [rest, error] = std::from_chars(at, end, value[i]);
      if (error != std::errc() || (i == 2 ? rest != end : rest == end || *rest != ',')) {
        refuse(coordinates, {.expected = "longitude,latitude,height",
                             .found = geom::in_quotes(text.substr(0, 60))});
      }
      at = rest + 1;
    }
    if (!is_place(value[0], value[1], value[2])) {
      refuse(coordinates,
             {.expected =
                  "a longitude within 180, a latitude within 90 degrees and a height within 1e8 m",
              .found = geom::in_quotes(text.substr(0, 60))});
    }
    return {value[1], value[0], value[2]};
  }

  static constexpr std::string_view kSpace = " \t\r\n";
  std::string_view source_;
  std::vector<GeoPoints> lines_;
};

// --- GeoJSON --------------------------------------------------------------------------------

class GeoJsonReader {
 public:
  explicit GeoJsonReader(std::string_view source) : source_(source) {}

  std::vector<GeoPoints> lines(const Json& root) {
    take(root, "the file");
    if (lines_.empty()) refuse({.expected = "a LineString", .found = "none"});
    return std::move(lines_);
  }

 private:
  [[noreturn]] void refuse(geom::Fault fault) const {
    throw geom::InputError(source_, std::move(fault));
  }

  const Json& list(const Json& object, const char* key, const std::string& where) const {
    const auto it = object.find(key);
    if (it == object.end() || !it->is_array()) {
      refuse({.expected = fmt::format("{} with a list \"{}\"", where, key),
              .found = it == object.end() ? "none" : shown(*it)});
    }
    return *it;
  }

  // A feature, a collection or a geometry.
  void take(const Json& object, const std::string& where) {
    if (!object.is_object()) {
      refuse({.key = where, .expected = "an object of GeoJSON", .found = shown(object)});
    }
    require_wgs84(object);
    const std::string type = object.contains("type") && object["type"].is_string()
                                 ? object["type"].get<std::string>()
                                 : std::string("no type");
    if (type == "FeatureCollection") {
      take_each(list(object, "features", where), "features");
    } else if (type == "GeometryCollection") {
      take_each(list(object, "geometries", where), "geometries");
    } else if (type == "Feature") {
      take_feature(object, where);
    } else if (type == "LineString") {
      lines_.push_back(points(list(object, "coordinates", where), where));
    } else if (type == "MultiLineString") {
      for (const Json& line : list(object, "coordinates", where)) {
        lines_.push_back(points(line, where));
      }
    } else {
      refuse({.item = where,
              .expected = "LineStrings",
              .found = fmt::format("{}, which is no line that could be flown", type.substr(0, 60)),
              .advice = "remove it"});
    }
  }

  void take_each(const Json& objects, const char* what) {
    for (std::size_t i = 0; i < objects.size(); ++i) {
      take(objects[i], fmt::format("{}[{}]", what, i));
    }
  }

  void take_feature(const Json& feature, const std::string& where) {
    const auto properties = feature.find("properties");
    if (properties != feature.end() && properties->is_object())
      require_absolute(*properties, where);
    if (!feature.contains("geometry"))
      refuse({.item = where, .expected = "a geometry", .found = "none"});
    take(feature["geometry"], where + ".geometry");
  }

  // As converters of KML leave it behind.
  void require_absolute(const Json& properties, const std::string& where) const {
    const auto mode = properties.find("altitudeMode");
    if (mode == properties.end() || mode->is_null() || *mode == "absolute") return;
    refuse({.item = where,
            .key = "altitudeMode",
            .expected = "absolute, as the ground is not in the file",
            .found = shown(*mode)});
  }

  void require_wgs84(const Json& object) const {
    if (geom::has_foreign_crs(object)) refuse(geom::foreign_crs());
  }

  GeoPoints points(const Json& line, const std::string& where) const {
    if (!line.is_array() || line.empty()) {
      refuse({.item = where, .expected = "a list of points", .found = shown(line)});
    }
    GeoPoints points;
    for (const Json& p : line) points.push_back(point(p, where));
    return points;
  }

  geom::GeodeticPlace point(const Json& p, const std::string& where) const {
    const bool numbers = p.is_array() && p.size() == 3 &&
                         std::all_of(p.begin(), p.end(), [](auto& v) { return v.is_number(); });
    if (!numbers) {
      refuse({.item = where,
              .expected = "a point of longitude, latitude and height",
              .found = shown(p)});
    }
    const double value[3] = {p[0], p[1], p[2]};
    if (!is_place(value[0], value[1], value[2])) {
      refuse({.item = where,
              .expected =
                  "a longitude within 180, a latitude within 90 degrees and a height within 1e8 m",
              .found = fmt::format("{},{},{}", value[0], value[1], value[2])});
    }
    return {value[1], value[0], value[2]};
  }

  std::string_view source_;
  std::vector<GeoPoints> lines_;
};

}  // namespace

void write_kml(std::ostream& out, const GeoLine& line) {
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
         "<kml xmlns=\"http://www.opengis.net/kml/2.2\">\n<Document>\n<Placemark>\n"
      << "<name>" << geom::escaped_markup(line.name) << "</name>\n";
  if (!line.note.empty())
    out << "<description>" << geom::escaped_markup(line.note) << "</description>\n";
  out << "<Style><LineStyle><color>ff0066ff</color><width>3</width></LineStyle></Style>\n"
         "<LineString>\n<altitudeMode>absolute</altitudeMode>\n<coordinates>\n";
  for (const geom::GeodeticPlace& p : line.points) out << coordinates(p) << '\n';
  out << "</coordinates>\n</LineString>\n</Placemark>\n</Document>\n</kml>\n";
}

void write_geojson(std::ostream& out, const GeoLine& line) {
  geom::JsonLine properties;
  properties.add("name", line.name);
  if (!line.note.empty()) properties.add("note", line.note);
  std::string text = R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":)";
  text += properties.object();
  text += R"(,"geometry":{"type":"LineString","coordinates":[)";
  for (std::size_t i = 0; i < line.points.size(); ++i) {
    text += (i ? ",\n[" : "\n[") + coordinates(line.points[i]) + ']';
  }
  out << text << "]}}]}\n";
}

std::vector<GeoPoints> read_kml(std::istream& in, std::string_view source) {
  return KmlReader(source).lines(parse_xml(all_of(in), source));
}

std::vector<GeoPoints> read_geojson(std::istream& in, std::string_view source) {
  return GeoJsonReader(source).lines(geom::parse_ordered_json(all_of(in), source));
}

}  // namespace traj
