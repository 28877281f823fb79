// worlds [FILES]: random tables of boxes and simulated worlds in the spellings of their formats. No
// marked box is left out in silence (support/left_out.h).

#include <Eigen/Geometry>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "geom/import/import_boxes.h"
#include "support/left_out.h"
#include "support/sdf_text.h"

namespace {

using geom::Aabb;
using geom::Vec3;
using support::chance;
using support::MarkedFile;
using support::one_of;
using support::Outcome;
using support::Random;

// On eighths of a metre, whose sums are exact; its lower corner is marked, and its upper one.
Aabb random_box(Random& random, MarkedFile& out) {
  const auto eighths = [&](int low, int high) { return (low + random.below(high - low)) / 8.0; };
  const Vec3 low(eighths(-4000, 4000), eighths(-4000, 4000), eighths(0, 400));
  const Vec3 size(eighths(1, 80), eighths(1, 80), eighths(1, 80));
  out.marks.push_back(low);
  out.marks.push_back(low + size);
  return {low, low + size};
}

auto reader_of(const geom::BoxFormat& format, const geom::ImportOptions& options = {}) {
  return [format, options](std::istream& in, const MarkedFile& file) {
    const geom::ImportedBoxes made = geom::import_boxes(in, format, "random", options);
    if (made.table.boxes.empty()) return Outcome::told;  // no map is made of it
    return support::outcome_of(support::held(made.table.boxes, file.marks), made.skipped);
  };
}

// Columns in any order, named in a line, in a comment, or not at all.
MarkedFile fcnd(Random& random) {
  MarkedFile out;
  std::vector<std::string> names = {"posX", "posY", "posZ", "halfSizeX", "halfSizeY", "halfSizeZ"};
  std::vector<std::size_t> order = {0, 1, 2, 3, 4, 5};
  const int said = random.below(5);  // in a line of their own; or in a comment; or not
  if (said > 0) {
    for (std::size_t i = 5; i > 0; --i) {
      std::swap(order[i], order[static_cast<std::size_t>(random.below(static_cast<int>(i) + 1))]);
    }
  }
  const std::string separator = one_of(random, {",", ";", ", "});
  std::string text = chance(random, 2) ? "lat0 37.5, lon0 -122.5\n" : "";
  if (chance(random, 4)) text += "# a city\n";
  if (said > 0) {
    if (said == 1) text += "# ";
    for (std::size_t i = 0; i < 6; ++i) text += (i ? separator : "") + names[order[i]];
    if (chance(random, 12)) text += separator + "posX";  // again: which of them is meant?
    text += '\n';
  }
  for (int i = 1 + random.below(4); i > 0; --i) {
    const Aabb box = random_box(random, out);
    double v[6];
    for (int k = 0; k < 3; ++k) {
      v[k] = (box.min[k] + box.max[k]) / 2;
      v[k + 3] = (box.max[k] - box.min[k]) / 2;
    }
    std::string line;
    for (std::size_t k = 0; k < 6; ++k) {
      std::string number = fmt::format("{}", v[order[k]]);
      if (said == 2) number = support::replaced(number, ".", one_of(random, {".", ".", ","}));
      line += (k ? separator : "") + number;
    }
    text += line + '\n';
  }
  out.bytes = support::with_line_ends(random, text);
  return out;
}

MarkedFile box_csv(Random& random) {
  MarkedFile out;
  std::string text = chance(random, 3) ? "# a city\n" : "";
  std::vector<std::string> names = {"min_x_m", "min_y_m", "min_z_m",
                                    "max_x_m", "max_y_m", "max_z_m"};
  if (chance(random, 8)) std::swap(names[0], names[1]);
  for (const std::string& name : names) text += name + ',';
  text += "label\n";
  for (int i = 1 + random.below(4); i > 0; --i) {
    Aabb box = random_box(random, out);
    if (chance(random, 20)) std::swap(box.min, box.max);
    text += fmt::format("{},{},{},{},{},{},{}\n", box.min.x(), box.min.y(), box.min.z(),
                        box.max.x(), box.max.y(), box.max.z(),
                        one_of(random, {"", "tower", "\"a, b\"", "\"a\nb\""}));
  }
  out.bytes = support::with_line_ends(random, text);
  return out;
}

// Corners in either order, comments behind lines, words that are no blocks.
MarkedFile block_text(Random& random) {
  MarkedFile out;
  std::string text = "# a room\nboundary -600 -600 0 600 600 99\n";
  const std::string separator = one_of(random, {" ", "  ", "\t", " ", ","});
  for (int i = 1 + random.below(4); i > 0; --i) {
    Aabb box = random_box(random, out);
    if (chance(random, 4)) std::swap(box.min[0], box.max[0]);
    if (chance(random, 4)) std::swap(box.min[2], box.max[2]);
    text += chance(random, 12) ? one_of(random, {"blok", "Block", "cylinder"}) : "block";
    for (const Vec3* corner : {&box.min, &box.max}) {
      for (const double v : *corner) text += separator + fmt::format("{}", v);
    }
    text += one_of(random, {"", " 200 0 0", " # a tower"}) + '\n';
    if (chance(random, 5)) text += "# between\n";
  }
  out.bytes = support::with_line_ends(random, text);
  return out;
}

MarkedFile world_json(Random& random) {
  using nlohmann::json;
  MarkedFile out;
  json world = {{"bounds", {{"extents", {-600, 600, -600, 600, 0, 99}}}},
                {"blocks", json::array()}};
  for (int i = 1 + random.below(4); i > 0; --i) {
    Aabb box = random_box(random, out);
    if (chance(random, 4)) std::swap(box.min[1], box.max[1]);
    json block = {
        {"extents", {box.min[0], box.max[0], box.min[1], box.max[1], box.min[2], box.max[2]}}};
    if (chance(random, 3)) block["color"] = {1, 0, 0};
    if (chance(random, 12)) block[one_of(random, {"yaw", "rotation", "scale"})] = 45;
    world["blocks"].push_back(block);
  }
  if (chance(random, 8)) world["cylinders"] = {1};
  out.bytes = world.dump(chance(random, 2) ? 2 : -1);
  return out;
}

MarkedFile voxels(Random& random) {
  MarkedFile out;
  std::string text = "voxel 64 48 32\n";
  for (int i = 1 + random.below(5); i > 0; --i) {
    const Vec3 low(random.below(64), random.below(48), random.below(chance(random, 20) ? 40 : 32));
    out.marks.push_back(low);
    text += fmt::format("{} {} {}\n", low.x(), low.y(), low.z());
  }
  out.bytes = support::with_line_ends(random, text);
  return out;
}

// Cells as a list over many lines, with comments between.
MarkedFile jps3d(Random& random) {
  MarkedFile out;
  const int dim[3] = {2 + random.below(3), 2 + random.below(3), 1 + random.below(3)};
  std::string text = fmt::format(
      "- origin: [-5, 3, 0]\n- dim: [{}, {}, {}]\n- resolution: 0.5\n# cells\n- data: [", dim[0],
      dim[1], dim[2]);
  const int count = dim[0] * dim[1] * dim[2];
  for (int at = 0; at < count; ++at) {
    const bool full = chance(random, 3);
    const Vec3 cell(at % dim[0], at / dim[0] % dim[1], at / dim[0] / dim[1]);
    if (full) out.marks.push_back(Vec3(-5, 3, 0) + 0.5 * cell);
    text += full ? one_of(random, {"100", "1", "50"}) : "0";
    if (at + 1 < count) text += one_of(random, {", ", ",", ", # more\n", ",\n"});
  }
  out.bytes = support::with_line_ends(random, text + "]\n");
  return out;
}

// Children of a node as two bits each, and then the nodes of those that have children: a way down
// to some level, with any leaves beside it.
std::string octree_node(Random& random, const Vec3& low, double side, int level, int last,
                        MarkedFile& out) {
  const int inner = level < last ? random.below(8) : -1;
  unsigned bits = 0;
  std::string below;
  for (int i = 0; i < 8; ++i) {
    const Vec3 corner = low + side / 2 * Vec3(i & 1, i >> 1 & 1, i >> 2 & 1);
    const int seen = i == inner ? 3 : chance(random, 2) ? 0 : 1 + random.below(2);
    bits |= static_cast<unsigned>(seen) << (2 * i);
    if (seen == 3) below = octree_node(random, corner, side / 2, level + 1, last, out);
    if (seen != 2) continue;
    const Vec3 share(random.uniform(0.01, 0.99), random.uniform(0.01, 0.99),
                     random.uniform(0.01, 0.99));
    out.marks.push_back(corner + side / 2 * share);
  }
  if (bits == 0) bits = 1;
  return std::string{static_cast<char>(bits & 255), static_cast<char>(bits >> 8)} + below;
}

// Heads in any order; trees of other kinds, cut ones, and bytes behind them.
MarkedFile octomap(Random& random) {
  MarkedFile out;
  const double resolution = one_of(random, std::vector<double>{0.05, 0.1, 0.25, 1.0 / 3, 2});
  const double side = 65536 * resolution;
  const std::string tree = octree_node(random, Vec3::Constant(-side / 2), side, 1,
                                       1 + random.below(chance(random, 20) ? 18 : 16), out);
  const std::string kind = chance(random, 20) ? "OcTree file" : "OcTree binary file";
  std::vector<std::string> head = {
      "id " + one_of(random, {"OcTree", "OcTree", "OcTree", "OcTree", "ColorOcTree"}),
      fmt::format("size {}", random.below(100)), fmt::format("res {}", resolution)};
  std::swap(head[0], head[static_cast<std::size_t>(random.below(3))]);
  out.bytes = "# Octomap " + kind + "\n" + (chance(random, 2) ? "# made by chance\n" : "");
  for (const std::string& line : head) out.bytes += line + '\n';
  out.bytes += "data\n" + tree;
  out.must_tell = kind == "OcTree file";
  switch (random.below(10)) {
    case 0:
      out.bytes.pop_back();
      out.must_tell = true;
      break;
    case 1:
      out.bytes += "more";
      out.must_tell = true;
      break;
    default:
      break;
  }
  return out;
}

// A body, and where it stands in its own frame.
struct Body {
  std::string text;
  std::vector<Vec3> marks;
};

Body random_body(Random& random) {
  switch (random.below(5)) {
    case 0:
      return {"<box><size>4 2 6</size></box>", {{2, 1, 3}, {-2, 1, -3}}};
    case 1:
      return {"<cylinder><radius>2</radius><length>5</length></cylinder>",
              {{1.4, 1.4, 2.5}, {0, -2, -2.5}}};
    case 2:
      return {"<sphere><radius>3</radius></sphere>", {{0, 0, 3}, {1.7, 1.7, -1.7}}};
    case 3:  // with a notch, which is free
      return {
          "<polyline><point>0 0</point><point>6 0</point><point>6 6</point><point>3 1</point>"
          "<point>0 6</point><height>4</height></polyline>",
          {{0.5, 0.5, 0}, {5.5, 4, 4}, {0.5, 4, 2}}};
    default:
      return {one_of(random, {"<heightmap/>", "<blob/>", "<mesh><uri>a.glb</uri></mesh>"}),
              {{0, 0, 0}}};
  }
}

struct Pose {
  std::string text;
  Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
};

Pose random_pose(Random& random) {
  const Vec3 at(random.below(200), random.below(200), random.below(30));
  const int turns = random.below(4);
  const double roll = turns == 3 ? random.uniform(-1, 1) : 0;
  const double pitch = turns == 3 ? random.uniform(-1, 1) : 0;
  const double yaw = turns > 0 ? random.uniform(-3, 3) : 0;
  Pose out;
  out.text =
      fmt::format("<pose>{} {} {} {} {} {}</pose>", at.x(), at.y(), at.z(), roll, pitch, yaw);
  out.place = Eigen::Translation3d(at) * Eigen::AngleAxisd(yaw, Vec3::UnitZ()) *
              Eigen::AngleAxisd(pitch, Vec3::UnitY()) * Eigen::AngleAxisd(roll, Vec3::UnitX());
  return out;
}

// The model that an <include> of the world names.
geom::SdfFile included;

// Models in models, bodies that collide or are seen, what moves or changes them, and an include.
MarkedFile sdf(Random& random) {
  MarkedFile out;
  const Pose pose = random_pose(random);
  const Pose inner = random_pose(random);
  const Body body = random_body(random);
  const bool is_included = chance(random, 3);
  for (const Vec3& mark : body.marks) out.marks.push_back(pose.place * (inner.place * mark));
  const std::string part = one_of(random, {"collision", "visual"});
  const std::string change = chance(random, 8) ? "<scale>2 2 2</scale>" : "";
  const std::string link = "<link name='l'>" + inner.text + '<' + part + " name='c'>" +
                           (is_included ? "" : change) + "<geometry>" + body.text +
                           "</geometry></" + part + "></link>";
  std::string world;
  if (chance(random, 3)) {
    world +=
        support::sdf_model("ground", "", "<plane><normal>0 0 1</normal><size>99 99</size></plane>");
  }
  if (is_included) {
    included = {"m/model.sdf", "<sdf version='1.9'><model name='m'>" + link + "</model></sdf>"};
    world += "<include><uri>m</uri>" + pose.text + change + "</include>";
  } else {
    world += "<model name='m'>" + pose.text + link + "</model>";
  }
  if (chance(random, 10))
    world += one_of(random, {"<actor name='a'/>", "<road name='r'/>", "<tower/>"});
  out.must_tell = !change.empty();
  out.bytes = support::with_line_ends(random, support::sdf(world));
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  const auto n = static_cast<std::size_t>(argc > 1 ? std::atof(argv[1]) : 1e4);
  geom::ImportOptions options;
  options.sdf.slack = 5;
  options.sdf.open = [](const std::string&, const std::string&) { return &included; };
  std::size_t lost = support::left_out("FCND table", n, fcnd, reader_of(geom::kFcnd));
  lost += support::left_out("box CSV", n, box_csv, reader_of(geom::kBoxCsv));
  lost += support::left_out("block text", n, block_text, reader_of(geom::kBlockText));
  lost += support::left_out("RotorPy JSON", n, world_json, reader_of(geom::kRotorPyWorld));
  lost += support::left_out("3dmap", n, voxels, reader_of(geom::kVoxelMap));
  lost += support::left_out("OctoMap", n, octomap, reader_of(geom::kOctomapTree));
  lost += support::left_out("jps3d", n, jps3d, reader_of(geom::kJps3d));
  lost += support::left_out("SDF", n, sdf, reader_of(geom::kGazeboWorld, options));
  return lost != 0;
}
