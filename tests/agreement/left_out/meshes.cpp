// meshes [FILES]: random models of triangles and polygons in the spellings of their formats. No
// marked polygon is left out in silence, whichever way a program cuts it (support/left_out.h).

#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>

#include "geom/archive/bytes.h"
#include "geom/model/gltf_model.h"
#include "geom/model/tileset.h"
#include "import/city_json.h"
#include "marked_polygon.h"
#include "support/glb_file.h"

namespace {

using geom::Vec3;
using left_out::mark;
using left_out::outcome;
using left_out::Polygon3;
using left_out::random_polygon;
using support::chance;
using support::MarkedFile;
using support::one_of;
using support::Outcome;
using support::Random;

template <class Read>
auto reader_of(const Read& read) {
  return [read](std::istream& in, const MarkedFile& file) {
    return outcome(read(in, "random"), file);
  };
}

// Faces by numbers from the first or the last vertex, behind comments, in groups.
MarkedFile obj(Random& random) {
  MarkedFile out;
  std::string text;
  std::size_t vertices = 0;
  for (int i = 1 + random.below(3); i > 0; --i) {
    const Polygon3 polygon = random_polygon(random, 7);
    mark(random, polygon, out);
    if (chance(random, 3))
      text += one_of(random, {"# a wall\n", "o wall\n", "g roof\n", "usemtl red\n", "s off\n"});
    for (const Vec3& v : polygon) {
      text += fmt::format("v {} {} {}{}\n", v.x(), v.y(), v.z(),
                          one_of(random, {"", "", " 1", " 0.5 0.5 0.5"}));
    }
    const bool from_last = chance(random, 2);
    const std::string behind = one_of(random, {"", "/1", "//1", "/1/1"});
    text += "f";
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      if (k == 2 && chance(random, 5)) text += " \\\n";
      const auto own = static_cast<long>(k);
      const long number = from_last ? own - static_cast<long>(polygon.size())
                                    : static_cast<long>(vertices) + own + 1;
      text += fmt::format(" {}{}", number, behind);
    }
    text += '\n';
    vertices += polygon.size();
  }
  if (chance(random, 6)) {
    text += one_of(random, {"l 1 2\n", "p 1\n", "curv 0 1 1 2\n"});
    out.must_tell = true;
  }
  out.bytes = support::with_line_ends(random, text);
  return out;
}

std::string ply_list(Random& random, std::size_t first, std::size_t count, bool strip) {
  const std::size_t more = strip && chance(random, 2) ? 2 : 0;  // a strip before, and its end
  std::string out = std::to_string(count + 2 * more);
  if (more) out += " 0 0 0 -1";
  for (std::size_t k = 0; k < count; ++k) out += fmt::format(" {}", first + k);
  return out + '\n';
}

// Faces, strips, and elements of other names with lists of vertices.
MarkedFile ply(Random& random) {
  MarkedFile out;
  const std::string element =
      one_of(random, {"face", "face", "face", "tristrips", "polygon", "triangle"});
  const bool strips = element == "tristrips";
  const std::string list = one_of(random, {"vertex_indices", "vertex_index"});
  std::string vertices;
  std::string lists;
  std::size_t count = 0;
  std::size_t polygons = 0;
  for (int i = 1 + random.below(3); i > 0; --i) {
    const Polygon3 polygon = random_polygon(random, strips ? 3 : 7);
    mark(random, polygon, out);
    for (const Vec3& v : polygon) vertices += fmt::format("{} {} {}\n", v.x(), v.y(), v.z());
    lists += ply_list(random, count, polygon.size(), strips);
    count += polygon.size();
    ++polygons;
  }
  const std::string unrelated = chance(random, 4) ? "element camera 1\nproperty float view\n" : "";
  out.bytes = support::with_line_ends(
      random,
      fmt::format("ply\nformat ascii 1.0\ncomment by chance\nelement vertex {}\nproperty "
                  "double x\nproperty double y\nproperty double z\n{}element {} {}\nproperty "
                  "list int int {}\nend_header\n{}{}{}",
                  count, unrelated, element, polygons, list, vertices,
                  unrelated.empty() ? "" : "0.5\n", lists));
  return out;
}

MarkedFile stl(Random& random) {
  MarkedFile out;
  const bool text = chance(random, 2);
  const int count = 1 + random.below(3);
  out.bytes = text ? "solid by chance\n" : std::string(80, ' ');
  if (!text) geom::append_bytes(out.bytes, static_cast<std::uint32_t>(count - chance(random, 10)));
  for (int i = 0; i < count; ++i) {
    const Polygon3 triangle = random_polygon(random, 3);
    mark(random, triangle, out);
    if (text) {
      out.bytes += "facet normal 0 0 1\nouter loop\n";
      for (const Vec3& v : triangle)
        out.bytes += fmt::format("vertex {} {} {}\n", v.x(), v.y(), v.z());
      out.bytes += "endloop\nendfacet\n";
      continue;
    }
    out.bytes += std::string(12, '\0');
    for (const Vec3& v : triangle) {
      for (int k = 0; k < 3; ++k) geom::append_bytes(out.bytes, static_cast<float>(v[k]));
    }
    out.bytes += std::string(2, '\0');
  }
  if (text) out.bytes = support::with_line_ends(random, out.bytes + "endsolid\n");
  return out;
}

// The triangle in single precision, and marks of that.
geom::TriangleMesh random_triangle(Random& random, MarkedFile& out) {
  Polygon3 triangle = random_polygon(random, 3);
  for (Vec3& v : triangle) v = v.cast<float>().cast<double>();
  mark(random, triangle, out);
  return {triangle, {{{0, 1, 2}, 0}}};
}

// One triangle as a list, strip or fan, which nodes place; what a later version demands; and
// meshes that the scene does not show.
MarkedFile gltf(Random& random) {
  MarkedFile out;
  support::GltfFile file(random_triangle(random, out));
  nlohmann::json& json = file.text;
  json["meshes"][0]["primitives"][0]["mode"] = 4 + random.below(3);
  if (chance(random, 3)) {
    const Vec3 by(random.below(100), random.below(100), random.below(100));
    json["nodes"][0]["translation"] = {by.x(), by.y(), by.z()};
    for (Vec3& p : out.marks) p += by;
  }
  if (chance(random, 3)) {  // within another node, which turns it by a quarter about y
    json["nodes"].push_back({{"children", nlohmann::json::array({0})},
                             {"rotation", {0, std::sqrt(0.5), 0, std::sqrt(0.5)}}});
    json["scenes"][0]["nodes"] = nlohmann::json::array({1});
    for (Vec3& p : out.marks) p = Vec3(p.z(), p.y(), -p.x());
  }
  switch (random.below(8)) {
    case 0:
      json["asset"]["minVersion"] = one_of(random, {"2.1", "3.0"});
      out.must_tell = true;
      break;
    case 1:
      json["asset"]["minVersion"] = "2.0";
      break;
    case 2:
      json["scenes"][0]["nodes"] = nlohmann::json::array();
      break;
    case 3:
      json["meshes"][0]["primitives"][0]["mode"] = random.below(4);
      break;
    default:
      break;
  }
  out.bytes = file.bytes();
  return out;
}

Outcome read_gltf(std::istream&, const MarkedFile& file) {
  const auto none = [](const std::string& path) -> std::string {
    throw geom::InputError(path, {.says = "no such file"});
  };
  return outcome(geom::read_gltf(file.bytes, "random", none), file);
}

// Files of a tileset by their names; the first is the text that the property shows.
std::map<std::string, std::string> tiles;

// Tiles that replace or add to each other; tilesets within, whatever their names end in.
MarkedFile tileset(Random& random) {
  using nlohmann::json;
  MarkedFile out;
  tiles.clear();
  const auto leaf = [&](const std::string& name) {
    MarkedFile own;
    tiles[name] = support::GltfFile(random_triangle(random, own)).bytes();
    for (const Vec3& p : own.marks) out.marks.push_back(geom::z_up_of_y_up(p));
    return json{{"content", {{"uri", name}}}, {"geometricError", 0}};
  };
  json root = {{"refine", one_of(random, {"REPLACE", "ADD"})}, {"geometricError", 9}};
  for (int i = random.below(3); i > 0; --i)
    root["children"].push_back(leaf(fmt::format("{}.glb", i)));
  const bool alone = !root.contains("children");
  if (alone || chance(random, 2)) {
    const std::string name =
        one_of(random, {"sub.json", "sub.jsn", "sub", "sub.tileset", "sub.JSON"});
    json inner = leaf("inner.glb");
    inner["refine"] = "ADD";
    tiles[name] =
        json{{"asset", {{"version", "1.1"}}}, {"geometricError", 9}, {"root", inner}}.dump();
    root["content"] = {{"uri", name}};
  } else {
    MarkedFile coarse;  // others replace it, or it is shown as well: no mark is set
    tiles["coarse.glb"] = support::GltfFile(random_triangle(random, coarse)).bytes();
    root["content"] = {{"uri", "coarse.glb"}};
  }
  out.bytes = json{{"asset", {{"version", "1.1"}}}, {"geometricError", 9}, {"root", root}}.dump();
  tiles["tileset.json"] = out.bytes;
  return out;
}

Outcome read_tiles(std::istream&, const MarkedFile& file) {
  const auto files = [](const std::string& path) -> std::string {
    const auto at = tiles.find(path);
    if (at == tiles.end()) throw geom::InputError(path, {.says = "no such file"});
    return at->second;
  };
  return outcome(geom::read_tileset("tileset.json", files).model, file);
}

// A surface, perhaps a template that stands somewhere; scales and matrices that lose it.
MarkedFile city_json(Random& random) {
  using nlohmann::json;
  MarkedFile out;
  const int scale = random.below(8);  // millimetres, or 0
  json vertices = json::array();
  const Vec3 low(random.below(1000), random.below(1000), random.below(100));
  for (const Vec3& corner : {low, Vec3(low + Vec3(3, 0, 0)), Vec3(low + Vec3(3, 3, 5))}) {
    out.marks.push_back(corner);
    const Vec3 stored = 1000 * corner;
    vertices.push_back({stored.x(), stored.y(), stored.z()});
  }
  const double unit = scale == 0 ? 0 : 0.001;
  json surface = {
      {"type", "MultiSurface"}, {"lod", "2"}, {"boundaries", json::parse("[[[0, 1, 2]]]")}};
  json root = {{"type", "CityJSON"},
               {"version", one_of(random, {"1.0", "1.1", "2.0"})},
               {"transform", {{"scale", {0.001, unit, 0.001}}, {"translate", {0, 0, 0}}}}};
  if (chance(random, 2)) {
    const int bottom = random.below(4);
    json templates = json::array();
    for (const Vec3& p : out.marks) templates.push_back({p.x(), p.y(), p.z()});
    root["geometry-templates"] = {{"templates", json::array({surface})},
                                  {"vertices-templates", templates}};
    surface = {
        {"type", "GeometryInstance"},
        {"template", 0},
        {"boundaries", json::array({0})},
        {"transformationMatrix",
         {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, bottom == 0 ? 0.1 : 0, 0, 0, bottom == 1 ? 2 : 1}}};
    out.must_tell = bottom < 2;
    const Vec3 reference = out.marks[0];
    for (Vec3& p : out.marks) p += reference;
  }
  root["vertices"] = vertices;
  root["CityObjects"] = {{"a", {{"type", "Building"}, {"geometry", json::array({surface})}}}};
  out.bytes = root.dump();
  return out;
}

Outcome read_city(std::istream& in, const MarkedFile& file) {
  const geom::CityModel model = geom::read_city_json(in, "random");
  std::vector<geom::Aabb> boxes;
  for (const geom::CitySurface& s : model.objects.at(0).geometries.at(0).surfaces) {
    for (const Vec3& v : s.at(0)) boxes.push_back(geom::grow({v, v}, Vec3::Constant(1e-6)));
  }
  return support::outcome_of(support::held(boxes, file.marks), model.skipped);
}

}  // namespace

int main(int argc, char** argv) {
  const auto n = static_cast<std::size_t>(argc > 1 ? std::atof(argv[1]) : 1e4);
  std::size_t lost = support::left_out("OBJ", n, obj, reader_of(geom::read_obj));
  lost += support::left_out("PLY mesh", n, ply, reader_of(geom::read_ply_model));
  lost += support::left_out("STL", n, stl, reader_of(geom::read_stl));
  lost += support::left_out("glTF", n, gltf, read_gltf);
  lost += support::left_out("3D Tiles", n, tileset, read_tiles);
  lost += support::left_out("CityJSON", n, city_json, read_city);
  return lost != 0;
}
