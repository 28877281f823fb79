#include "geom/model/model.h"

#include "fuzz/reader.h"
#include "geom/model/gltf_model.h"
#include "geom/model/place_model.h"
#include "geom/model/tileset.h"

namespace {

void gltf_model(std::istream& in) {
  const std::string bytes = fuzz::rest_of(in);
  geom::read_gltf(bytes, "fuzz", [&](const std::string&) { return bytes; });
}

// A tileset, then a zero byte, then the bytes of every file that it names, subtrees too; of a few
// hundred of these, since implicit tiles may name millions.
void tileset(std::istream& in) {
  const std::string bytes = fuzz::rest_of(in);
  const std::size_t end = std::min(bytes.find('\0'), bytes.size());
  std::size_t opened = 0;
  geom::TilesModel tiles = geom::read_tileset("tileset.json", [&](const std::string& path) {
    if (++opened > 300) throw geom::InputError(path, {.says = "one too many"});
    return path == "tileset.json" ? bytes.substr(0, end)
                                  : bytes.substr(std::min(end + 1, bytes.size()));
  });
  if (tiles.on_earth) geom::place_on_map(tiles.model, std::nullopt, "fuzz");
}

}  // namespace

std::vector<fuzz::Reader> fuzz::readers() {
  return {{"gltf_model", gltf_model},
          {"obj", [](std::istream& in) { geom::read_obj(in, "fuzz"); }},
          {"ply_model", [](std::istream& in) { geom::read_ply_model(in, "fuzz"); }},
          {"stl", [](std::istream& in) { geom::read_stl(in, "fuzz"); }},
          {"tileset", tileset}};
}
