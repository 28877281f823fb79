#include "gdal_whole.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string_view>

#include "gdal_content.h"
#include "geom/base/error.h"
#include "geom/text/counted.h"
#include "geom/text/parse_json.h"
#include "text/json_outline.h"
#include "text/xml_events.h"

namespace geom::gis {
namespace {

using Json = nlohmann::json;

[[noreturn]] void refuse_part(const std::string& name, const std::string& why) {
  throw InputError(name,
                   {.says = fmt::format("this is a part of what its server has: {}; ask for the "
                                        "rest and join both, or for fewer features at once",
                                        why)});
}

bool is_cut(const Json& object) {
  return object.is_object() && object.value("exceededTransferLimit", Json()) == true;
}

const Json& member(const Json& object, const char* key) {
  static const Json kNone;
  const auto at = object.find(key);
  return at == object.end() ? kNone : *at;
}

// What ESRI's servers and those of OGC API Features or WFS say of an answer that they cut.
void require_all(const Json& root, std::size_t here, const std::string& name) {
  if (is_cut(root) || is_cut(member(root, "properties"))) {
    refuse_part(name, "\"exceededTransferLimit\" is true");
  }
  const Json& returned = member(root, "numberReturned");
  for (const char* key : {"numberMatched", "totalFeatures"}) {
    const Json& all = member(root, key);
    if (!all.is_number()) continue;
    if (all > here || (returned.is_number() && all > returned)) {
      refuse_part(name, fmt::format("\"{}\" is {}, and the file has {}", key, all.dump(),
                                    counted(here, "feature")));
    }
  }
  const Json& links = member(root, "links");
  if (!links.is_array()) return;
  for (const Json& link : links) {
    if (link.is_object() && member(link, "rel") == "next") {
      refuse_part(name, "a link leads to its next part");
    }
  }
}

// GDAL knows a "crs" of the whole file alone, and takes WGS 84 for one that it does not understand.
void require_known_crs(const Json& root, const std::string& name) {
  const auto crs = root.find("crs");
  if (crs == root.end()) return;
  const Json& about = crs->is_object() ? member(*crs, "properties") : Json();
  const Json& system = about.is_object() ? member(about, "name") : Json();
  if (!crs->is_object() || member(*crs, "type") != "name" || !system.is_string()) {
    throw InputError(name, {.item = "\"crs\"",
                            .expected = "the name of a coordinate reference system",
                            .found = shown(*crs),
                            .advice = "write its name, or take the member away where coordinates "
                                      "are longitude and latitude (WGS 84)"});
  }
  required_reference(system.get<std::string>(), name);
}

// JSON-FG has a shape of its own, such as a prism, and "geometry" is a makeshift beside it.
void refuse_unread_members(const Json& feature, const std::string& what, const std::string& name) {
  if (feature.is_object() && member(feature, "place").is_object()) {
    throw InputError(name, {.item = what,
                            .expected = "its shape as \"geometry\"",
                            .found = "a \"place\" (JSON-FG), which is not read",
                            .advice = "export GeoJSON with heights, or CityJSON"});
  }
  if (!feature.is_object() || !feature.contains("crs")) return;
  throw InputError(name, {.item = what,
                          .expected = "a \"crs\" of the whole file alone",
                          .found = "one of the feature"});
}

std::string_view without_mark(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  return text;
}

// GDAL takes other words for these, and then not all that belongs to them.
void require_type(const Json& value, std::initializer_list<const char*> types,
                  const std::string& what, const std::string& name) {
  const Json found = value.is_object() ? member(value, "type") : Json();
  if (std::find(types.begin(), types.end(), found) != types.end()) return;
  throw InputError(
      name, {.item = what,
             .expected = fmt::format("\"type\" to be {} in these letters", fmt::join(types, ", ")),
             .found = shown(found),
             .advice = "correct it"});
}

// The root with its own members and those of its features; a count of the features.
std::size_t require_json(const std::string& path, const std::string& name) {
  constexpr std::size_t kDepth = 3;
  const std::string text = content_of(path, name);
  const Json root = json_outline(without_mark(text), name, kDepth);
  require_type(root,
               {"FeatureCollection", "Feature", "Polygon", "MultiPolygon", "GeometryCollection",
                "Point", "MultiPoint", "LineString", "MultiLineString"},
               "the file", name);
  const Json& features = member(root, "features");
  const std::size_t count = features.is_array() ? features.size() : 0;
  for (std::size_t i = 0; i < count; ++i) {
    require_type(features[i], {"Feature"}, fmt::format("feature {}", i), name);
    refuse_unread_members(features[i], fmt::format("feature {}", i), name);
  }
  require_known_crs(root, name);
  require_all(root, count, name);
  return count;
}

bool same_system(const Json& a, const Json& b) {
  return a == b || (member(a, "wkid").is_number() && member(a, "wkid") == member(b, "wkid"));
}

// GDAL looks at the system of the whole file alone, and passes over arcs.
void require_esri_geometry(const Json& geometry, const Json& system, const std::string& what,
                           const std::string& name) {
  if (!geometry.is_object()) return;
  for (const char* arcs : {"curveRings", "curvePaths"}) {
    if (geometry.contains(arcs)) {
      throw InputError(name, {.item = what,
                              .expected = "rings",
                              .found = fmt::format("\"{}\", which has arcs", arcs),
                              .advice = "ask its server for them without arcs "
                                        "(returnTrueCurves=false)"});
    }
  }
  const Json& own = member(geometry, "spatialReference");
  if (!own.is_object() || (system.is_object() && same_system(own, system))) return;
  throw InputError(name, {.item = what,
                          .expected = "the \"spatialReference\" of the file",
                          .found = shown(own),
                          .advice = "bring all features to one system, and name it once"});
}

std::size_t require_esri_json(const DatasetHandle& dataset, const std::string& path,
                              const std::string& name) {
  constexpr std::size_t kDepth = 5;  // up to the reference systems of geometries
  const std::string text = content_of(path, name);
  const Json root = json_outline(without_mark(text), name, kDepth);
  const Json& system = member(root, "spatialReference");
  const OGRLayerH layer = gdal().layer(dataset.get(), 0);
  if (system.is_object() && !system.empty() && layer && !gdal().layer_reference(layer)) {
    throw InputError(name, {.item = "\"spatialReference\"",
                            .expected = "a coordinate reference system that PROJ knows",
                            .found = shown(system)});
  }
  const Json& features = member(root, "features");
  const std::size_t count = features.is_array() ? features.size() : 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (!features[i].is_object()) continue;
    require_esri_geometry(member(features[i], "geometry"), system, fmt::format("feature {}", i),
                          name);
  }
  require_all(root, count, name);
  return count;
}

// A feature a line, or one behind each record separator.
std::size_t require_json_sequence(const std::string& path, const std::string& name) {
  const std::string text = content_of(path, name);
  const char between = text.find('\x1e') != text.npos ? '\x1e' : '\n';
  std::size_t features = 0;
  std::size_t line = 0;
  for (std::string_view rest = without_mark(text); !rest.empty();) {
    const std::size_t end = std::min(rest.find(between), rest.size());
    const std::string_view record = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (between == '\n') ++line;
    if (record.find_first_not_of(" \t\r\n") == record.npos) continue;
    const Json feature = json_outline(record, name, 1, line);
    const std::string what = fmt::format("feature {}", features);
    require_type(feature, {"Feature"}, what, name);
    refuse_unread_members(feature, what, name);
    ++features;
  }
  return features;
}

class KmlHandler : public XmlHandler {
 public:
  explicit KmlHandler(const std::string& name) : name_(name) {}

  void begin(const XmlTag& tag) override {
    if (tag.name == "Placemark") ++placemarks;
    if (tag.name != "NetworkLink" && tag.name != "Model") return;
    throw InputError(
        name_, tag.line,
        {.expected = "all places in this file",
         .found = fmt::format("a {}, which leads to another file: {}", tag.name,
                              tag.name == "Model"
                                  ? "give the model itself to skyway-mesh, and take it out here"
                                  : "get that file too, and put both into one without the link")});
  }
  void text(std::string_view) override {}
  void end(std::size_t) override {}

  std::size_t placemarks = 0;

 private:
  const std::string& name_;
};

std::size_t require_kml(const std::string& path, const std::string& name) {
  KmlHandler handler(name);
  for (const std::string& text : kml_texts(path, name)) read_xml(text, name, handler);
  return handler.placemarks;
}

// GDAL's names of the formats that it reads whole, after what require_whole() refuses.
constexpr std::string_view kWhole[] = {
    "GeoJSON",    "GeoJSONSeq", "ESRIJSON", "GPKG", "SQLite", "ESRI Shapefile",
    "FlatGeobuf", "KML",        "LIBKML",   "GML",  "CSV"};

// Of a drawing, for example, GDAL leaves out solids and meshes, and does not tell the unit.
void require_whole_format(std::string_view driver, const std::string& name) {
  if (std::find(std::begin(kWhole), std::end(kWhole), driver) != std::end(kWhole)) return;
  throw InputError(
      name,
      {.expected = "polygons as GeoJSON, GeoPackage, Shapefile, FlatGeobuf, SQLite, KML, GML "
                   "or CSV",
       .found = fmt::format("a format of which GDAL may leave out parts ({})", driver),
       .advice = "export one of these from the program that made it, as polygons with heights"});
}

}  // namespace

std::vector<std::string> kml_texts(const std::string& path, const std::string& name) {
  if (!EQUAL(gdal().extension_of(path.c_str()), "kmz")) return {content_of(path, name)};
  std::vector<std::string> out;
  const std::string archive = "/vsizip/" + path;
  const ListHandle files(gdal().list_files(archive.c_str()));
  for (char** file = files.get(); file && *file; ++file) {
    if (!EQUAL(gdal().extension_of(*file), "kml")) continue;
    out.push_back(content_of(fmt::format("{}/{}", archive, *file), name));
  }
  return out;
}

std::vector<std::string> files_beside(const DatasetHandle& dataset, const std::string& path) {
  const ListHandle files(gdal().files_of(dataset.get()));
  std::vector<std::string> out;
  for (char** file = files.get(); file && *file; ++file) {
    if (path != *file && !STARTS_WITH(*file, "/vsi")) out.emplace_back(*file);
  }
  return out;
}

std::size_t require_whole(const DatasetHandle& dataset, const std::string& path,
                          const std::string& name) {
  const std::string_view driver = gdal().driver_name(gdal().driver_of(dataset.get()));
  if (driver == "OSM") {
    throw InputError(name, {.says = "this is OpenStreetMap data, of which GDAL leaves out heights",
                            .advice = "read it with --format osm"});
  }
  require_whole_format(driver, name);
  if (driver == "GeoJSON") return require_json(path, name);
  if (driver == "ESRIJSON") return require_esri_json(dataset, path, name);
  if (driver == "GeoJSONSeq") return require_json_sequence(path, name);
  if (driver == "KML" || driver == "LIBKML") return require_kml(path, name);
  if (driver == "ESRI Shapefile") require_whole_shapefile(dataset, name);
  if (driver == "FlatGeobuf") {
    const OGRLayerH layer = gdal().layer(dataset.get(), 0);
    const GIntBig stated = layer ? gdal().feature_count(layer, TRUE) : 0;
    return stated > 0 ? static_cast<std::size_t>(stated) : 0;
  }
  return 0;
}

}  // namespace geom::gis
