#include "geom/import/city_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <istream>
#include <nlohmann/json.hpp>
#include <set>

#include "geom/base/error.h"
#include "geom/shape/vec3.h"
#include "geom/text/parse_json.h"
#include "geom/text/text_table.h"

namespace geom {
namespace {

using Json = nlohmann::json;
using Surface = std::vector<std::vector<Vec3>>;  // an outer ring, then holes

constexpr double kWall = 1e-6;  // m2 in plan: below it a surface stands upright
// What lies on the ground: without a geometry, nothing of it is known to be in the air.
const std::set<std::string> kLevel = {"TINRelief", "LandUse", "WaterBody",      "Waterway",
                                      "Road",      "Railway", "TransportSquare"};
const std::set<std::string> kGround = {"TINRelief", "LandUse", "WaterBody", "Waterway"};

class Reader {
 public:
  explicit Reader(std::string_view source) : source_(source) {}

  CityJson read(std::istream& in) {
    const Json root = parse_json(in, source_);
    if (!root.is_object() || root.value("type", Json()) != "CityJSON") {
      refuse("expected a JSON object with \"type\":\"CityJSON\"");
    }
    const std::string version = root.value("version", Json()).dump();
    if (!version.starts_with("\"1.") && !version.starts_with("\"2.")) {
      refuse("expected CityJSON version 1.0, 1.1 or 2.0, found " + version.substr(0, 40));
    }
    read_crs(root);
    read_vertices(root);
    read_templates(root);
    const Json objects = root.value("CityObjects", Json());
    if (!objects.is_object()) refuse("expected \"CityObjects\" to be an object");
    std::uint64_t id = 0;
    for (const auto& [name, object] : objects.items()) read_object(name, object, id++);
    if (out_.footprints.empty()) refuse("expected at least one object with surfaces, found none");
    return std::move(out_);
  }

 private:
  [[noreturn]] void refuse(std::string_view message) const { throw InputError(source_, message); }
  [[noreturn]] void refuse_object(std::string_view message) const {
    refuse(fmt::format("object \"{}\": {}", object_.substr(0, 60), message));
  }

  void read_crs(const Json& root) {
    const Json metadata = root.value("metadata", Json::object());
    if (!metadata.is_object()) return;
    const Json named = metadata.value("referenceSystem", Json());
    if (!named.is_string()) return;
    const std::string text = named.get<std::string>();
    const std::size_t at = text.find_last_of(":/");
    const std::string code = at == std::string::npos ? text : text.substr(at + 1);
    const bool digits = !code.empty() && code.size() < 10 &&
                        code.find_first_not_of("0123456789") == std::string::npos;
    out_.crs = digits ? "EPSG:" + code : text;
  }

  double number(const Json& value, std::string_view what) const {
    if (!value.is_number() || !std::isfinite(value.get<double>())) {
      refuse(fmt::format("{} must be a finite number, found {}", what, shown(value)));
    }
    return value.get<double>();
  }

  Vec3 triple(const Json& value, std::string_view what) const {
    if (!value.is_array() || value.size() != 3) {
      refuse(fmt::format("{} must be 3 numbers, found {}", what, shown(value)));
    }
    return {number(value[0], what), number(value[1], what), number(value[2], what)};
  }

  void read_vertices(const Json& root) {
    Vec3 scale = Vec3::Ones();
    Vec3 translate = Vec3::Zero();
    if (root.contains("transform")) {
      const Json& transform = root["transform"];
      if (!transform.is_object()) refuse("transform must be an object");
      scale = triple(transform.value("scale", Json()), "transform.scale");
      translate = triple(transform.value("translate", Json()), "transform.translate");
    }
    const Json vertices = root.value("vertices", Json());
    if (!vertices.is_array()) refuse("expected \"vertices\" to be an array");
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Vec3 v =
          triple(vertices[i], fmt::format("vertex {}", i)).cwiseProduct(scale) + translate;
      if (!(v.cwiseAbs().maxCoeff() <= kLargestCoordinate)) {
        refuse(fmt::format("vertex {} lies beyond 1e8", i));
      }
      vertices_.push_back(v);
    }
  }

  void read_object(const std::string& name, const Json& object, std::uint64_t id) {
    object_ = name;
    if (!object.is_object() || !object.value("type", Json()).is_string()) {
      refuse_object("expected an object with a type");
    }
    const std::string type = object["type"];
    other_ = 0;
    const std::vector<const Json*> geometries = finest(object);
    if (geometries.empty()) {
      const bool parent = object.contains("children") && object["children"].is_array() &&
                          !object["children"].empty();
      if (other_ > 0 || !(parent || kLevel.contains(type) || type == "CityObjectGroup")) {
        out_.skipped.add(fmt::format("{} without surfaces", type.substr(0, 40)),
                         name.substr(0, 60));
      }
      return;
    }
    surfaces_.clear();
    for (const Json* geometry : geometries) collect_geometry(*geometry);
    add_footprints(id, kGround.contains(type));
  }

  // Templates: shapes that objects place by a matrix and a reference point.
  void read_templates(const Json& root) {
    const Json section = root.value("geometry-templates", Json());
    if (section.is_null()) return;
    const Json list = section.is_object() ? section.value("templates", Json()) : Json();
    const Json vertices =
        section.is_object() ? section.value("vertices-templates", Json()) : Json();
    if (!list.is_array() || !vertices.is_array()) {
      refuse("geometry-templates must have the arrays templates and vertices-templates");
    }
    for (const Json& geometry : list) {
      if (!geometry.is_object()) refuse("a geometry template must be an object");
      templates_.push_back(geometry);
    }
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      template_vertices_.push_back(triple(vertices[i], fmt::format("template vertex {}", i)));
    }
  }

  const Json& template_of(const Json& instance) const {
    const Json index = instance.value("template", Json());
    if (!index.is_number_unsigned() || index.get<std::uint64_t>() >= templates_.size()) {
      refuse_object(
          fmt::format("a template must be below {}, found {}", templates_.size(), shown(index)));
    }
    return templates_[index.get<std::size_t>()];
  }

  static bool is_instance(const Json& geometry) {
    return geometry.value("type", Json()) == "GeometryInstance";
  }

  void collect_geometry(const Json& geometry) {
    if (!is_instance(geometry)) {
      collect(geometry.value("boundaries", Json()), 0);
      return;
    }
    const Json at = geometry.value("boundaries", Json());
    if (!at.is_array() || at.size() != 1) {
      refuse_object("the boundaries of a GeometryInstance must be one vertex index");
    }
    const Vec3 reference = vertices_[index_below(at[0], vertices_.size())];
    const Json numbers = geometry.value("transformationMatrix", Json());
    if (!numbers.is_array() || numbers.size() != 16) {
      refuse_object("a transformationMatrix must be 16 numbers");
    }
    Eigen::Matrix4d matrix;
    for (int i = 0; i < 16; ++i) {
      matrix(i / 4, i % 4) = number(numbers[static_cast<std::size_t>(i)], "transformationMatrix");
    }
    std::vector<Vec3> placed;
    for (const Vec3& v : template_vertices_) {
      const Eigen::Vector4d h = matrix * Eigen::Vector4d(v.x(), v.y(), v.z(), 1);
      placed.push_back(h.head<3>() + reference);
      if (!(placed.back().cwiseAbs().maxCoeff() <= kLargestCoordinate)) {
        refuse_object("a template's vertex is placed beyond 1e8");
      }
    }
    std::swap(vertices_, placed);
    collect(template_of(geometry).value("boundaries", Json()), 0);
    std::swap(vertices_, placed);
  }

  // The geometries of the highest level of detail that are made of surfaces.
  std::vector<const Json*> finest(const Json& object) {
    std::vector<const Json*> best;
    double best_lod = -1;
    if (!object.contains("geometry")) return best;
    const Json& list = object["geometry"];
    if (!list.is_array()) refuse_object("geometry must be an array");
    for (const Json& geometry : list) {
      if (!geometry.is_object()) refuse_object("a geometry must be an object");
      const Json& shape = is_instance(geometry) ? template_of(geometry) : geometry;
      const std::string type = shape.value("type", Json()).dump();
      if (type.find("Surface") == std::string::npos && type.find("Solid") == std::string::npos) {
        ++other_;
        continue;
      }
      const Json lod = shape.value("lod", Json(0));
      const double value = lod.is_string()   ? parse_number(lod.get<std::string>()).value_or(0)
                           : lod.is_number() ? lod.get<double>()
                                             : 0;
      if (value < best_lod) continue;
      if (value > best_lod) best.clear();
      best.push_back(&geometry);
      best_lod = value;
    }
    return best;
  }

  // Boundaries nest to a depth that their type gives; a surface is an array of rings of indices.
  void collect(const Json& boundaries, int depth) {
    if (!boundaries.is_array()) refuse_object("boundaries must be nested arrays of vertex indices");
    if (depth > 4) refuse_object("boundaries nest too deep");
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
      refuse_object(fmt::format("a vertex index must be below {}, found {}", count, shown(index)));
    }
    return index.get<std::size_t>();
  }

  Surface surface_of(const Json& rings) const {
    Surface surface;
    for (const Json& ring : rings) {
      if (!ring.is_array() || ring.empty()) refuse_object("a ring must have vertices");
      surface.emplace_back();
      for (const Json& index : ring) {
        surface.back().push_back(vertices_[index_below(index, vertices_.size())]);
      }
    }
    return surface;
  }

  void add_footprints(std::uint64_t id, bool ground) {
    double bottom = kLargestCoordinate;
    for (const Surface& surface : surfaces_) {
      for (const Vec3& v : surface[0]) bottom = std::min(bottom, v.z());
    }
    if (surfaces_.empty()) {
      out_.skipped.add("object without surfaces", object_.substr(0, 60));
      return;
    }
    ++out_.objects;
    for (const Surface& surface : surfaces_) {
      Footprint f;
      f.id = id;
      f.bottom = bottom;
      f.top = bottom;
      f.ground = ground;
      double area = 0;
      for (std::size_t r = 0; r < surface.size(); ++r) {
        std::vector<Vec2> ring;
        for (const Vec3& v : surface[r]) {
          ring.push_back({v.x(), v.y()});
          f.top = std::max(f.top, v.z());
        }
        if (r == 0) area = plan_area(ring);
        if (r == 0) {
          f.polygon.outer = std::move(ring);
        } else {
          f.polygon.holes.push_back(std::move(ring));
        }
      }
      f.likely_covered = area < kWall || f.top == bottom;
      out_.footprints.push_back(std::move(f));
    }
  }

  static double plan_area(const std::vector<Vec2>& ring) {
    double twice = 0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      const Vec2 a = ring[i] - ring[0];
      const Vec2 b = ring[i + 1] - ring[0];
      twice += a.x() * b.y() - a.y() * b.x();
    }
    return std::abs(twice) / 2;
  }

  std::string source_;
  std::string object_;
  std::vector<Vec3> vertices_;  // while a template is placed: its own
  std::vector<Json> templates_;
  std::vector<Vec3> template_vertices_;
  std::vector<Surface> surfaces_;
  std::size_t other_ = 0;  // geometries of the object that are no surfaces
  CityJson out_;
};

}  // namespace

CityJson read_city_json(std::istream& in, std::string_view source) {
  return Reader(source).read(in);
}

}  // namespace geom
