#pragma once

// 3D Tiles 1.0 and 1.1 (OGC 22-025r4) as triangles.
//
// Example, not run:
//   const auto files = [](const std::string& name) {
//     std::ifstream file("tiles/" + name, std::ios::binary);
//     return std::string(std::istreambuf_iterator<char>(file), {});
//   };
//   const geom::TilesModel city = geom::read_tileset("tileset.json", files);
//   std::cout << city.model.mesh.triangles.size() << " triangles of " << city.tiles << " tiles\n";

#include "geom/model/draco_mesh.h"
#include "geom/model/model.h"

namespace geom {

struct TilesModel {
  // Parts are features: by the batch table's "name" or "id", else by the node. z up, metres.
  Model model;
  bool on_earth = true;     // the coordinates are earth-centred (ECEF); else they are local
  std::size_t tiles = 0;    // whose content was read
  std::size_t coarser = 0;  // whose content was not, since others replace it
};

// The `tileset.json` at `path` and all that it names, by `files` (paths relative to the folder of
// `path`). Content is b3dm, glb, glTF, or another tileset, by its bytes and not by its name. Of
// tiles that replace each other the finest are taken: a tile's own content is left out only where
// each of its children has some. Bounding volumes are ignored, so no tile is left out because of
// them. Implicit tiles exist if their subtrees say so.
//
// Skipped and counted: content of other kinds (i3dm, pnts, cmpt and unknown ones). Refused
// (InputError): a tileset within itself, subtrees whose bits contradict each other or the tileset,
// a b3dm whose lengths do not add up, a path that leaves the folder or names another host, and what
// read_gltf() refuses; `draco` is as there.
TilesModel read_tileset(const std::string& path, const ModelFiles& files,
                        const DracoDecoder& draco = {});

}  // namespace geom
