#include <cstdlib>

#include "fuzz/reader.h"
#include "geom/import/box_csv.h"
#include "geom/import/building_height.h"
#include "geom/import/fcnd_csv.h"
#include "geom/import/import_boxes.h"
#include "geom/import/keep_out.h"
#include "geom/import/sdf_world.h"
#include "import/city_footprints.h"
#include "import/city_json.h"

namespace {

// The text as every attribute in turn, and as all at once: what comes out is always a height.
void building_height(std::istream& in) {
  const std::string text = fuzz::rest_of(in);
  for (const char* only : {"", "height", "building:levels", "min_height", "building:min_level"}) {
    const auto tag = [&](const char* key) {
      return *only == 0 || std::string(key) == only ? text : std::string();
    };
    const geom::BuildingHeight h = geom::building_height(tag, {});
    if (!(h.bottom >= 0 && h.bottom < h.top && h.top <= 2e4)) std::abort();
  }
}

void keep_out(std::istream& in) {
  const geom::Frame frame{geom::Axes::enu, geom::GeodeticOrigin{60, 25, 0}, ""};
  geom::read_keep_out(in, "fuzz", frame, {.epoch = "2026-05-04T06:30:00Z"});
}

// Whether simulators agree on the bytes as a COLLADA file that a world names.
void sdf_collada(std::istream& in) {
  const geom::SdfFile mesh{"m.dae", fuzz::rest_of(in)};
  geom::SdfOptions options;
  options.open_mesh = [&](const std::string&, const std::string&) { return &mesh; };
  options.read_collada = [](const geom::SdfFile& file) {
    std::istringstream obj("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    return geom::read_obj(obj, file.name);
  };
  std::istringstream world(
      "<sdf version='1.6'><model name='m'><link name='l'><visual name='v'><geometry><mesh>"
      "<uri>m.dae</uri></mesh></geometry></visual></link></model></sdf>");
  geom::read_sdf_world(world, "fuzz", options);
}

void sdf_world(std::istream& in) {
  const geom::SdfFile model{
      "model",
      "<sdf version='1.6'><model name='i'><link name='l'><visual name='v'><geometry><box>"
      "<size>1 1 1</size></box></geometry></visual></link></model></sdf>"};
  const geom::SdfFile mesh{"mesh", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nl 1 2\n"};
  geom::SdfOptions options;
  options.slack = 1;  // round bodies are tried in their own tests
  options.open = [&](const std::string& uri, const std::string&) {
    return uri.empty() ? nullptr : &model;
  };
  options.open_mesh = [&](const std::string& uri, const std::string&) {
    return uri.size() > 20 ? nullptr : &mesh;
  };
  geom::read_sdf_world(in, "fuzz", options);
}

const geom::ImportOptions kAllBlocked{.unknown_blocked = true};

}  // namespace

std::vector<fuzz::Reader> fuzz::readers() {
  return {
      {"block_text", [](std::istream& in) { geom::import_boxes(in, geom::kBlockText, "fuzz"); }},
      {"box_csv", [](std::istream& in) { geom::read_box_csv(in, "fuzz"); }},
      {"building_height", building_height},
      {"city_json",
       [](std::istream& in) { geom::footprints_of(geom::read_city_json(in, "fuzz"), 1, {}); }},
      {"fcnd_csv", [](std::istream& in) { geom::read_fcnd_csv(in, "fuzz"); }},
      {"jps3d_map",
       [](std::istream& in) { geom::import_boxes(in, geom::kJps3d, "fuzz", kAllBlocked); }},
      {"keep_out", keep_out},
      {"octomap",
       [](std::istream& in) { geom::import_boxes(in, geom::kOctomapTree, "fuzz", kAllBlocked); }},
      {"sdf_collada", sdf_collada},
      {"sdf_world", sdf_world},
      {"voxel_3dmap", [](std::istream& in) { geom::import_boxes(in, geom::kVoxelMap, "fuzz"); }},
      {"world_json",
       [](std::istream& in) { geom::import_boxes(in, geom::kRotorPyWorld, "fuzz"); }}};
}
