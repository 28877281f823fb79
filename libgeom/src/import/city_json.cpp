#include "import/city_json.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cerrno>
#include <cmath>
#include <istream>
#include <nlohmann/json.hpp>

#include "geom/base/error.h"
#include "geom/base/file_error.h"
#include "geom/base/vec3.h"
#include "geom/import/building_height.h"
#include "geom/text/parse_json.h"
#include "geom/text/text_table.h"

namespace geom {
namespace {

using Json = nlohmann::json;

// Attributes that may tell a height.
constexpr const char* kHeights[] = {"measuredHeight",     "height",          "averageHeight",
                                    "storeysAboveGround", "building:levels", "building:height"};

// A member without a copy of it; null where there is none.
const Json& member(const Json& object, const char* key) {
  static const Json none;
  const auto at = object.find(key);
  return at == object.end() ? none : *at;
}

class Reader {
 public:
  explicit Reader(std::string_view source) : source_(source) {}

  // A document, or a sequence of them, one a line. Of no document does an object follow another.
  CityModel read(std::istream& in) {
    std::string head;
    std::string line;
    bool sequence = false;
    for (std::size_t number = 1; std::getline(in, line); ++number) {
      const std::string_view words = trimmed(line);
      if (!sequence && trimmed(head).ends_with('}') && words.starts_with('{')) {
        sequence = true;
        begin_sequence(parse_json(head, source_));
      }
      if (!sequence) {
        head += line;
        if (!in.eof()) head += '\n';
      } else if (!words.empty()) {
        line_ = number;
        read_feature(parse_json(line, source_, number));
      }
    }
    if (in.bad()) {
      throw FileError(FileUse::reading, std::string(source_), EIO);
    }
    if (!sequence) read_document(parse_json(head, source_));
    line_ = 0;
    if (!surfaces_found_)
      refuse({.expected = "at least one object with surfaces", .found = "none"});
    return std::move(out_);
  }

 private:
  [[noreturn]] void refuse(Fault fault) const {
    if (line_ > 0) throw InputError(source_, line_, std::move(fault));
    throw InputError(source_, std::move(fault));
  }
  [[noreturn]] void refuse_object(Fault fault) const {
    refuse(within(fmt::format("object \"{}\"", object_.substr(0, 60)), std::move(fault)));
  }

  void read_document(const Json& root) {
    const Json type = root.is_object() ? root.value("type", Json()) : Json();
    if (type == "CityJSONFeature") {
      refuse({.expected = "a first line with \"type\":\"CityJSON\" and a transform",
              .found = "a CityJSONFeature",
              .advice = "put the line of its sequence or service before it"});
    }
    if (type != "CityJSON") refuse({.expected = "a JSON object with \"type\":\"CityJSON\""});
    require_version(root.value("version", Json()));
    read_crs(root);
    read_transform(root);
    read_vertices(root);
    read_templates(root);
    read_objects(root, "");
  }

  void begin_sequence(const Json& root) {
    line_ = 1;
    read_document(root);
    if (!root.contains("transform"))
      refuse({.expected = "a \"transform\" for the lines that follow"});
  }

  void read_feature(const Json& feature) {
    const Json type = feature.is_object() ? feature.value("type", Json()) : feature;
    if (type != "CityJSONFeature") {
      refuse({.expected = "\"type\":\"CityJSONFeature\"",
              .found = shown(type),
              .advice = "one sequence, of one CityJSON and its features, is read"});
    }
    const Json metadata = feature.value("metadata", Json::object());
    for (const char* key : {"transform", "geometry-templates", "referenceSystem"}) {
      if (!feature.contains(key) && !(metadata.is_object() && metadata.contains(key))) continue;
      refuse({.expected = fmt::format("\"{}\" in the first line alone", key),
              .found = "it in a feature"});
    }
    vertices_.clear();
    read_vertices(feature);
    read_objects(feature, fmt::format("{}/", line_));
    const Json id = feature.value("id", Json());
    if (id.is_string() && !feature["CityObjects"].contains(id.get<std::string>())) {
      miss(id, "a feature");
    }
  }

  // `where`: what keeps apart objects of the same name.
  void read_objects(const Json& root, const std::string& where) {
    const Json& objects = member(root, "CityObjects");
    if (!objects.is_object()) refuse({.expected = "\"CityObjects\" to be an object"});
    for (const auto& [name, object] : objects.items()) {
      CityObject made = read_object(name, object);
      const std::string whole = whole_of(objects, name);
      made.is_part = whole != name;
      made.whole = where + whole;
      made.has_parts = has_parts(objects, object);
      surfaces_found_ |= std::any_of(made.geometries.begin(), made.geometries.end(),
                                     [](const CityGeometry& g) { return !g.surfaces.empty(); });
      out_.objects.push_back(std::move(made));
    }
  }

  // Notes what an object names as its own and the file does not have.
  bool has_parts(const Json& objects, const Json& object) {
    bool any = false;
    for (const char* key : {"children", "members", "parents"}) {
      for (const Json& other : member(object, key)) {
        const bool there = other.is_string() && objects.contains(other.get<std::string>());
        if (!there) miss(other, fmt::format("{} of \"{}\"", key, object_.substr(0, 60)));
        any |= there && key == std::string_view("children");
      }
    }
    return any;
  }

  void miss(const Json& name, const std::string& of) {
    out_.skipped.add("object that is named and not in the file",
                     fmt::format("{}, {}", shown(name), of));
  }

  void require_version(const Json& version) const {
    const std::string said = version.is_string() ? version.get<std::string>() : "";
    for (const char* known : {"1.0", "1.1", "2.0"}) {
      if (said == known || said.starts_with(std::string(known) + ".")) return;
    }
    refuse({.expected = "CityJSON version 1.0, 1.1 or 2.0", .found = shown(version)});
  }

  void read_crs(const Json& root) {
    const Json metadata = root.value("metadata", Json::object());
    if (!metadata.is_object()) return;
    const Json named = metadata.value("referenceSystem", Json());
    if (named.is_null()) return;
    if (!named.is_string()) {
      refuse({.key = "referenceSystem", .expected = "a text", .found = shown(named)});
    }
    const std::string text = named.get<std::string>();
    const std::size_t at = text.find_last_of(":/");
    const std::string code = at == std::string::npos ? text : text.substr(at + 1);
    const bool digits = !code.empty() && code.size() < 10 &&
                        code.find_first_not_of("0123456789") == std::string::npos;
    // The last code of a system of two is that of its heights alone.
    const bool compound = text.find("EPSG") != text.rfind("EPSG");
    // A number of IGNF or of OGC is another system than that of EPSG.
    const bool of_epsg = at == std::string::npos || text.find("EPSG") != std::string::npos ||
                         text.find("epsg") != std::string::npos;
    out_.crs = digits && !compound && of_epsg ? "EPSG:" + code : text;
  }

  // Number `index` of a list.
  Vec3 triple(const Json& value, std::string_view what, std::size_t index) const {
    const auto is_finite = [](const Json& v) {
      return v.is_number() && std::isfinite(v.get<double>());
    };
    const bool plain =
        value.is_array() && value.size() == 3 && std::all_of(value.begin(), value.end(), is_finite);
    if (!plain) return triple(value, fmt::format("{} {}", what, index));  // says what is wrong
    return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
  }

  double number(const Json& value, std::string_view what) const {
    if (!value.is_number() || !std::isfinite(value.get<double>())) {
      refuse({.key = std::string(what), .expected = "a finite number", .found = shown(value)});
    }
    return value.get<double>();
  }

  Vec3 triple(const Json& value, std::string_view what) const {
    if (!value.is_array() || value.size() != 3) {
      refuse({.key = std::string(what), .expected = "3 numbers", .found = shown(value)});
    }
    return {number(value[0], what), number(value[1], what), number(value[2], what)};
  }

  void read_transform(const Json& root) {
    if (!root.contains("transform")) return;
    const Json& transform = root["transform"];
    if (!transform.is_object()) refuse({.key = "transform", .expected = "an object"});
    scale_ = triple(transform.value("scale", Json()), "transform.scale");
    translate_ = triple(transform.value("translate", Json()), "transform.translate");
    if ((scale_.array() == 0).any()) {
      refuse({.key = "transform.scale",
              .expected = "3 numbers other than 0",
              .found = shown(transform["scale"])});
    }
  }

  void read_vertices(const Json& root) {
    const Json& vertices = member(root, "vertices");
    if (!vertices.is_array()) refuse({.expected = "\"vertices\" to be an array"});
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Vec3 v = triple(vertices[i], "vertex", i).cwiseProduct(scale_) + translate_;
      if (!(v.cwiseAbs().maxCoeff() <= kLargestCoordinate)) {
        refuse({.says = fmt::format("vertex {} lies beyond 1e8", i)});
      }
      vertices_.push_back(v);
    }
  }

  CityObject read_object(const std::string& name, const Json& object) {
    object_ = name;
    if (!object.is_object() || !object.value("type", Json()).is_string()) {
      refuse_object({.expected = "an object with a type"});
    }
    CityObject out;
    out.type = object["type"];
    out.name = name;
    read_attributes(member(object, "attributes"), out);
    if (!object.contains("geometry")) return out;
    const Json& list = object["geometry"];
    if (!list.is_array()) refuse_object({.key = "geometry", .expected = "an array"});
    for (const Json& geometry : list) {
      if (!geometry.is_object()) refuse_object({.key = "a geometry", .expected = "an object"});
      read_geometry(geometry, out);
    }
    return out;
  }

  static void read_attributes(const Json& attributes, CityObject& out) {
    if (!attributes.is_object()) return;
    for (const auto& [name, value] : attributes.items()) {
      const auto key = std::find_if(std::begin(kHeights), std::end(kHeights),
                                    [&](const char* height) { return is_attribute(name, height); });
      if (key == std::end(kHeights) || value.is_null()) continue;
      add_value(value.is_string() ? value.get<std::string>() : value.dump(), out.attributes[*key]);
    }
  }

  void read_geometry(const Json& geometry, CityObject& out) {
    const Json& shape = is_instance(geometry) ? template_of(geometry) : geometry;
    const std::string type = shape.value("type", Json()).dump();
    if (type.find("Surface") == std::string::npos && type.find("Solid") == std::string::npos) {
      ++out.others;
      ++out.drawn;
      return;
    }
    const Json lod = shape.value("lod", Json(0));
    CityGeometry g;
    g.lod = lod.is_string()   ? parse_number(lod.get<std::string>()).value_or(0)
            : lod.is_number() ? lod.get<double>()
                              : 0;
    g.roofs_only = says_roofs_only(shape);
    surfaces_.clear();
    collect_geometry(geometry);
    g.surfaces = std::move(surfaces_);
    out.geometries.push_back(std::move(g));
  }

  static bool says_roofs_only(const Json& shape) {
    const Json& semantics = member(shape, "semantics");
    if (!semantics.is_object()) return false;
    const Json& list = member(semantics, "surfaces");
    return list.is_array() && !list.empty() &&
           std::all_of(list.begin(), list.end(), [](const Json& s) {
             return s.is_object() && s.value("type", Json()) == "RoofSurface";
           });
  }

  // The outermost object that `name` is a part of; groups have members, not parts.
  std::string whole_of(const Json& objects, const std::string& name) const {
    std::string whole = name;
    for (int depth = 0; depth < 10; ++depth) {
      const Json& object = objects[whole];
      if (!object.is_object()) break;
      const Json& parents = member(object, "parents");
      const auto parent = std::find_if(parents.begin(), parents.end(), [&](const Json& p) {
        if (!p.is_string()) return false;
        const auto at = objects.find(p.get<std::string>());
        return at != objects.end() && at->is_object() &&
               at->value("type", Json()) != "CityObjectGroup";
      });
      if (parent == parents.end()) break;
      whole = parent->get<std::string>();
    }
    return whole;
  }

  // Templates: shapes that objects place by a matrix and a reference point.
  void read_templates(const Json& root) {
    const Json& section = member(root, "geometry-templates");
    if (section.is_null()) return;
    const Json list = section.is_object() ? section.value("templates", Json()) : Json();
    const Json vertices =
        section.is_object() ? section.value("vertices-templates", Json()) : Json();
    if (!list.is_array() || !vertices.is_array()) {
      refuse({.says = "geometry-templates must have the arrays templates and vertices-templates"});
    }
    for (const Json& geometry : list) {
      if (!geometry.is_object()) refuse({.key = "a geometry template", .expected = "an object"});
      templates_.push_back(geometry);
    }
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      template_vertices_.push_back(triple(vertices[i], "template vertex", i));
    }
  }

  const Json& template_of(const Json& instance) const {
    const Json index = instance.value("template", Json());
    if (!index.is_number_unsigned() || index.get<std::uint64_t>() >= templates_.size()) {
      refuse_object({.key = "a template",
                     .expected = fmt::format("below {}", templates_.size()),
                     .found = shown(index)});
    }
    return templates_[index.get<std::size_t>()];
  }

  static bool is_instance(const Json& geometry) {
    return geometry.value("type", Json()) == "GeometryInstance";
  }

  void collect_geometry(const Json& geometry) {
    if (!is_instance(geometry)) {
      collect(member(geometry, "boundaries"), 0);
      return;
    }
    const Json at = geometry.value("boundaries", Json());
    if (!at.is_array() || at.size() != 1) {
      refuse_object(
          {.key = "the boundaries of a GeometryInstance", .expected = "one vertex index"});
    }
    const Vec3 reference = vertices_[index_below(at[0], vertices_.size())];
    const Json numbers = geometry.value("transformationMatrix", Json());
    if (!numbers.is_array() || numbers.size() != 16) {
      refuse_object({.key = "a transformationMatrix", .expected = "16 numbers"});
    }
    Eigen::Matrix4d matrix;
    for (int i = 0; i < 16; ++i) {
      matrix(i / 4, i % 4) = number(numbers[static_cast<std::size_t>(i)], "transformationMatrix");
    }
    if (matrix.row(3) != Eigen::RowVector4d(0, 0, 0, 1)) {
      refuse_object({.key = "the last row of a transformationMatrix",
                     .expected = "0 0 0 1",
                     .found = shown(Json(numbers.begin() + 12, numbers.end()))});
    }
    if (matrix.determinant() == 0) {
      refuse_object({.expected = "a transformationMatrix that keeps solids solid",
                     .found = "one of volume 0"});
    }
    std::vector<Vec3> placed;
    for (const Vec3& v : template_vertices_) {
      const Eigen::Vector4d h = matrix * Eigen::Vector4d(v.x(), v.y(), v.z(), 1);
      placed.push_back(h.head<3>() + reference);
      if (!(placed.back().cwiseAbs().maxCoeff() <= kLargestCoordinate)) {
        refuse_object({.says = "a template's vertex is placed beyond 1e8"});
      }
    }
    std::swap(vertices_, placed);
    collect(member(template_of(geometry), "boundaries"), 0);
    std::swap(vertices_, placed);
  }

  // Boundaries nest to a depth that their type gives; a surface is an array of rings of indices.
  void collect(const Json& boundaries, int depth) {
    if (!boundaries.is_array())
      refuse_object({.key = "boundaries", .expected = "nested arrays of vertex indices"});
    if (depth > 4) refuse_object({.says = "boundaries nest too deep"});
    for (const Json& part : boundaries) {
      const bool surface = part.is_array() && !part.empty() && part[0].is_array() &&
                           !part[0].empty() && !part[0][0].is_array();
      if (surface) {
        surfaces_.push_back(surface_of(part));
      } else {
        collect(part, depth + 1);
      }
    }
  }

  std::size_t index_below(const Json& index, std::size_t count) const {
    if (!index.is_number_unsigned() || index.get<std::uint64_t>() >= count) {
      refuse_object({.key = "a vertex index",
                     .expected = fmt::format("below {}", count),
                     .found = shown(index)});
    }
    return index.get<std::size_t>();
  }

  CitySurface surface_of(const Json& rings) const {
    CitySurface surface;
    for (const Json& ring : rings) {
      if (!ring.is_array() || ring.empty()) refuse_object({.says = "a ring must have vertices"});
      surface.emplace_back();
      for (const Json& index : ring) {
        surface.back().push_back(vertices_[index_below(index, vertices_.size())]);
      }
    }
    return surface;
  }

  std::string source_;
  std::size_t line_ = 0;  // in a sequence
  std::string object_;
  Vec3 scale_ = Vec3::Ones();
  Vec3 translate_ = Vec3::Zero();
  bool surfaces_found_ = false;
  std::vector<Vec3> vertices_;  // while a template is placed: its own
  std::vector<Json> templates_;
  std::vector<Vec3> template_vertices_;
  std::vector<CitySurface> surfaces_;
  CityModel out_;
};

}  // namespace

CityModel read_city_json(std::istream& in, std::string_view source) {
  return Reader(source).read(in);
}

}  // namespace geom
