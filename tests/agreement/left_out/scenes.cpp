// scenes [FILES]: random COLLADA and 3DS files, as skyway-mesh reads them, and COLLADA meshes of
// worlds. No marked polygon is left out in silence (support/left_out.h).

#include <cstdlib>

#include "geom/archive/bytes.h"
#include "geom/import/import_boxes.h"
#include "geom/model/assimp_scene.h"
#include "marked_polygon.h"
#include "support/sdf_text.h"

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

using Place = Eigen::Affine3d;

// Files of all kinds, or mostly those that simulators show alike.
enum class Spelling { any, agreed };

// Numbers between any white space; seldom a comment between them.
class Numbers {
 public:
  explicit Numbers(Random& random) : random_(random) {}
  template <class T>
  void add(const T& value) {
    if (!text_.empty()) text_ += one_of(random_, {" ", " ", "  ", "\n", "\t", "\n\t"});
    if (chance(random_, 400)) text_ += "<!-- so many -->";
    text_ += fmt::format("{}", value);
  }
  const std::string& text() const { return text_; }

 private:
  Random& random_;
  std::string text_;
};

// The elements of a <mesh> that hold positions, and how its polygons name these.
struct Corners {
  std::string sources;
  int inputs = 1;  // indices a corner
  int offset = 0;  // of these, the position's
};

// In threes or wider, from the first number on or later.
Corners write_corners(Random& random, Spelling spelling, const std::string& id,
                      const std::vector<Vec3>& points) {
  const int seldom = spelling == Spelling::any ? 8 : 40;
  const std::size_t first = chance(random, seldom) ? 3 : 0;
  const bool wide = chance(random, seldom);
  Numbers numbers(random);
  for (std::size_t i = 0; i < first; ++i) numbers.add(7);
  for (const Vec3& p : points) {
    for (const double v : p) numbers.add(v);
    if (wide) numbers.add(1);
  }
  const std::size_t stride = wide ? 4 : 3;
  Corners out;
  out.sources = fmt::format(
      "<source id=\"{0}p\"><float_array id=\"{0}a\" count=\"{1}\">{2}</float_array>"
      "<technique_common><accessor source=\"#{0}a\" offset=\"{3}\" count=\"{4}\" stride=\"{5}\">"
      "<param name=\"X\" type=\"float\"/><param name=\"Y\" type=\"float\"/>"
      "<param name=\"Z\" type=\"float\"/></accessor></technique_common></source>\n"
      "<vertices id=\"{0}v\"><input semantic=\"POSITION\" source=\"#{0}p\"/></vertices>\n",
      id, first + stride * points.size(), numbers.text(), first, points.size(), stride);
  if (chance(random, 2)) {
    out.inputs = 2;
    out.offset = random.below(2);
  }
  return out;
}

std::string inputs_of(const Corners& corners, const std::string& id) {
  std::string out =
      fmt::format("<input semantic=\"VERTEX\" source=\"#{}v\" offset=\"{}\"/>", id, corners.offset);
  if (corners.inputs == 2) {
    out += fmt::format("<input semantic=\"NORMAL\" source=\"#{}p\" offset=\"{}\"/>", id,
                       1 - corners.offset);
  }
  return out;
}

// Polygons of `sizes` corners each, which come one after the other.
std::string write_polygons(Random& random, const std::string& id, const Corners& corners,
                           const std::vector<std::size_t>& sizes, const std::string& element) {
  std::vector<Numbers> lists;
  Numbers counts(random);
  std::size_t corner = 0;
  const bool one_list = element == "triangles" || element == "polylist";
  for (const std::size_t size : sizes) {
    if (lists.empty() || !one_list) lists.emplace_back(random);
    for (std::size_t k = 0; k < size; ++k, ++corner) {
      for (int i = 0; i < corners.inputs; ++i) lists.back().add(i == corners.offset ? corner : 0);
    }
    counts.add(size);
  }
  std::string out =
      fmt::format("<{} count=\"{}\">{}", element, sizes.size(), inputs_of(corners, id));
  if (element == "polylist") out += "<vcount>" + counts.text() + "</vcount>";
  for (const Numbers& list : lists) out += "<p>" + list.text() + "</p>";
  return out + "</" + element + ">\n";
}

// A <geometry> with its polygons marked, in its own numbers.
std::string write_geometry(Random& random, Spelling spelling, const std::string& id,
                           const std::string& ids, MarkedFile& out) {
  const std::string element =
      chance(random, 20) ? "trifans"
                         : one_of(random, {"triangles", "polylist", "polygons", "tristrips"});
  const bool triangles = element[0] == 't';
  std::vector<Vec3> points;
  std::vector<std::size_t> sizes;
  for (int i = 1 + random.below(3); i > 0; --i) {
    const Polygon3 polygon = random_polygon(random, triangles ? 3 : 6);
    mark(random, polygon, out);
    points.insert(points.end(), polygon.begin(), polygon.end());
    sizes.push_back(polygon.size());
  }
  const Corners corners = write_corners(random, spelling, ids, points);
  std::string more;
  if (chance(random, 30)) {
    more = "<lines count=\"1\">" + inputs_of(corners, ids) + "<p>0 1 1 0</p></lines>";
    out.must_tell = corners.inputs == 1;
  }
  return "<geometry id=\"" + id + "\"><mesh>" + corners.sources +
         write_polygons(random, ids, corners, sizes, element) + more + "</mesh></geometry>\n";
}

// A step of a node's place, as its elements write it.
std::string random_step(Random& random, Place& place, MarkedFile& out) {
  const auto whole = [&](int most) { return random.below(2 * most) - most; };
  switch (random.below(40)) {
    case 0:
      out.must_tell = true;  // programs differ in how it looks
      return "<lookat>1 2 3 4 5 6 0 0 1</lookat>";
    case 1:
      out.must_tell = true;  // about an axis of no length, or of any
      return one_of(random, {"<rotate>0 0 0 30</rotate>", "<rotate>0 0 2 30</rotate>",
                             "<rotate>1 1 0 50</rotate>"});
    default:
      break;
  }
  switch (random.below(4)) {
    case 0: {
      const Vec3 by(whole(100), whole(100), whole(100));
      place.translate(by);
      return fmt::format("<translate sid=\"t\">{} {}\n{}</translate>", by.x(), by.y(), by.z());
    }
    case 1: {
      const int axis = random.below(3);
      const int angle = whole(180);
      place.rotate(Eigen::AngleAxisd(angle * std::acos(-1) / 180, Vec3::Unit(axis)));
      return fmt::format("<rotate>{} {} {} {}</rotate>", +(axis == 0), +(axis == 1), +(axis == 2),
                         angle);
    }
    case 2: {
      const Vec3 by(1 + random.below(3), 1, 0.5 * (1 + random.below(3)));
      place.scale(by);
      return fmt::format("<scale>{} {} {}</scale>", by.x(), by.y(), by.z());
    }
    default: {
      Place step = Place::Identity();
      step.translate(Vec3(whole(100), whole(100), whole(100)));
      step.rotate(Eigen::AngleAxisd(whole(3), Vec3(1, 2, 2) / 3));
      place = place * step;
      std::string text;
      for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column)
          text += fmt::format("{} ", step.matrix()(row, column));
      }
      return "<matrix>" + text + "</matrix>";
    }
  }
}

// Nodes in nodes, which place a geometry directly or by a node of the library.
struct Nodes {
  std::string scene;
  std::string library;
};

Nodes write_nodes(Random& random, Spelling spelling, const std::string& geometry, Place& place,
                  MarkedFile& out) {
  Nodes nodes;
  std::string begin;
  std::string end;
  for (int depth = 1 + random.below(2); depth > 0; --depth) {
    begin += fmt::format("<node id=\"{}n{}\">", geometry, depth);
    for (int steps = random.below(spelling == Spelling::any ? 3 : 2); steps > 0; --steps)
      begin += random_step(random, place, out);
    end += "</node>";
  }
  std::string shown = "<instance_geometry url=\"#" + geometry + "\"/>";
  if (chance(random, 4)) {
    nodes.library =
        "<node id=\"" + geometry + "l\">" + random_step(random, place, out) + shown + "</node>";
    shown = "<instance_node url=\"#" + geometry + "l\"/>";
  }
  nodes.scene = begin + shown + end + '\n';
  return nodes;
}

// What the file says of its axes and its unit, and what follows for its numbers.
std::string write_asset(Random& random, Spelling spelling, Place& place) {
  const bool any = spelling == Spelling::any || chance(random, 8);
  const std::string up = any ? one_of(random, {"Z_UP", "Y_UP", "X_UP", ""}) : "Z_UP";
  const double unit = one_of(random, std::vector<double>{1, 1, 1, 0.01, 0.0254, 2});
  place = Place::Identity();
  place.scale(unit);
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  if (up == "X_UP") turn << 0, -1, 0, 0, 0, -1, 1, 0, 0;
  if (up == "Y_UP" || up.empty()) turn << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  place = place * turn;
  const std::string space = chance(random, 12) ? one_of(random, {" ", "\n"}) : "";
  std::string out = "<asset>";
  if (unit != 1 || chance(random, 2)) out += fmt::format("<unit name=\"u\" meter=\"{}\"/>", unit);
  if (!up.empty()) out += "<up_axis>" + space + up + space + "</up_axis>";
  return out + "</asset>\n";
}

// One geometry or two, in a scene that places each; ids that come twice, and an asset of a part.
MarkedFile collada_of(Random& random, Spelling spelling) {
  MarkedFile out;
  Place file;
  const std::string asset = write_asset(random, spelling, file);
  const bool twice = chance(random, 20);
  std::string geometries;
  Nodes all;
  const int count = 1 + random.below(2);
  for (int i = 0; i < count; ++i) {
    const std::string id = fmt::format("g{}", i);
    MarkedFile own;
    geometries += write_geometry(random, spelling, id, twice ? "g" : id, own);
    Place place = Place::Identity();
    const Nodes nodes = write_nodes(random, spelling, id, place, own);
    all.scene += nodes.scene;
    all.library += nodes.library;
    for (const Vec3& p : own.marks) out.marks.push_back(file * (place * p));
    out.must_tell = out.must_tell || own.must_tell;
  }
  if (chance(random, 20)) {
    const std::string other = asset.find("X_UP") == asset.npos ? "X_UP" : "Z_UP";
    const std::string own =
        chance(random, 2) ? "<unit meter=\"3\"/>" : "<up_axis>" + other + "</up_axis>";
    geometries = support::replaced(geometries, "<mesh>", "<asset>" + own + "</asset><mesh>");
    out.must_tell = true;
  }
  std::string text = "<?xml version=\"1.0\"?>\n<COLLADA version=\"1.4.1\">\n" + asset +
                     "<library_geometries>" + geometries + "</library_geometries>\n";
  if (!all.library.empty()) text += "<library_nodes>" + all.library + "</library_nodes>\n";
  text += "<library_visual_scenes><visual_scene id=\"s\">" + all.scene +
          "</visual_scene></library_visual_scenes>\n"
          "<scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>\n";
  out.bytes = support::with_line_ends(random, text);
  return out;
}

MarkedFile collada(Random& random) { return collada_of(random, Spelling::any); }

auto reader_of(geom::Model (*read)(const std::string& bytes, const std::string& source)) {
  return [read](std::istream&, const MarkedFile& file) {
    return outcome(read(file.bytes, "random"), file);
  };
}

// The mesh that the world names.
geom::SdfFile mesh_file;

// A COLLADA file in a model of a world, scaled and placed.
MarkedFile world(Random& random) {
  MarkedFile out = collada_of(random, Spelling::agreed);
  mesh_file = {"m.dae", out.bytes};
  const Vec3 by(1 + random.below(3), 1, 1);
  const Vec3 at(random.below(200), random.below(200), random.below(30));
  const double yaw = chance(random, 2) ? 0 : random.uniform(-3, 3);
  for (Vec3& p : out.marks) {
    p = Eigen::AngleAxisd(yaw, Vec3::UnitZ()) * by.cwiseProduct(p) + at;
  }
  const std::string scale =
      by.x() == 1 ? "" : fmt::format("<scale>{} {} {}</scale>", by.x(), by.y(), by.z());
  out.bytes = support::sdf(
      support::sdf_model("m", fmt::format("{} {} {} 0 0 {}", at.x(), at.y(), at.z(), yaw),
                         "<mesh><uri>m.dae</uri>" + scale + "</mesh>"));
  return out;
}

Outcome read_world(std::istream& in, const MarkedFile& file) {
  geom::ImportOptions options;
  options.sdf.slack = 5;
  options.sdf.open_mesh = [](const std::string&, const std::string&) { return &mesh_file; };
  options.sdf.read_collada = [](const geom::SdfFile& dae) {
    return geom::read_collada(dae.text, dae.name);
  };
  geom::ImportedBoxes made = geom::import_boxes(in, geom::kGazeboWorld, "random", options);
  for (geom::Aabb& box : made.table.boxes) box = geom::grow(box, Vec3::Constant(1e-6));
  return support::outcome_of(support::held(made.table.boxes, file.marks), made.skipped);
}

std::string chunk(int id, const std::string& inside) {
  std::string out;
  geom::append_bytes(out, static_cast<std::uint16_t>(id));
  geom::append_bytes(out, static_cast<std::uint32_t>(6 + inside.size()));
  return out + inside;
}

// A mesh of triangles; a place of its own, which its vertices have already.
std::string mesh_of_3ds(Random& random, MarkedFile& out) {
  std::string vertices;
  std::string faces;
  const int count = 1 + random.below(4);
  geom::append_bytes(vertices, static_cast<std::uint16_t>(3 * count));
  geom::append_bytes(faces, static_cast<std::uint16_t>(count));
  for (int i = 0; i < count; ++i) {
    Polygon3 triangle = random_polygon(random, 3);
    for (Vec3& v : triangle) v = v.cast<float>().cast<double>();
    mark(random, triangle, out);
    for (int k = 0; k < 3; ++k) {
      for (const double v : triangle[static_cast<std::size_t>(k)])
        geom::append_bytes(vertices, static_cast<float>(v));
      geom::append_bytes(faces, static_cast<std::uint16_t>(3 * i + k));
    }
    geom::append_bytes(faces, static_cast<std::uint16_t>(7));
  }
  if (chance(random, 3)) {  // which material the first face has
    std::string material = "m" + std::string(1, '\0');
    for (const int n : {1, 0}) geom::append_bytes(material, static_cast<std::uint16_t>(n));
    faces += chunk(0x4130, material);
  }
  std::string inside = chunk(0x4110, vertices) + chunk(0x4120, faces);
  if (chance(random, 3)) {
    std::string place;
    for (const int n : {0, 1, 0, -1, 0, 0, 0, 0, 1, random.below(99), random.below(99), 3})
      geom::append_bytes(place, static_cast<float>(n));
    inside += chunk(0x4160, place);
  }
  return inside;
}

MarkedFile three_ds(Random& random) {
  MarkedFile out;
  std::string objects;
  for (int i = 1 + random.below(3); i > 0; --i) {
    objects += chunk(0x4000, fmt::format("o{}", i) + std::string(1, '\0') +
                                 chunk(0x4100, mesh_of_3ds(random, out)));
  }
  std::string three;
  geom::append_bytes(three, std::uint32_t{3});
  std::string scale;
  geom::append_bytes(scale, chance(random, 10) ? 2.0f : 1.0f);
  out.bytes =
      chunk(0x4D4D, chunk(0x0002, three) +
                        chunk(0x3D3D, chunk(0x3D3E, three) + chunk(0x0100, scale) + objects));
  if (chance(random, 10)) out.bytes.resize(out.bytes.size() - 7);
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  const auto n = static_cast<std::size_t>(argc > 1 ? std::atof(argv[1]) : 1e4);
  std::size_t lost = support::left_out("COLLADA", n, collada, reader_of(geom::read_collada));
  lost += support::left_out("COLLADA of worlds", n, world, read_world);
  lost += support::left_out("3DS", n, three_ds, reader_of(geom::read_3ds));
  return lost != 0;
}
