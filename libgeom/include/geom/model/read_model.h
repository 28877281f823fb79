#pragma once

// One door to all readers of models, by the format of the file.
//
// Example:
//   const auto open = [](const std::string& path) {
//     std::ifstream file(path, std::ios::binary);
//     return std::string(std::istreambuf_iterator<char>(file), {});
//   };
//   const geom::ModelSource source = geom::read_model("house.obj", "auto", open);
//   assert(source.format == "obj");

#include <cstddef>
#include <optional>
#include <string>

#include "geom/model/place_model.h"

namespace geom {

struct ModelSource {
  Model model;
  std::string format;                // "obj", "stl", "ply", "gltf", "collada", "3ds" or "tiles"
  std::string hash;                  // "sha256:…" of the file and of all that it names
  std::size_t files = 1;             // how many these are
  std::optional<std::size_t> tiles;  // of tiles: whose content was read
  std::size_t coarser = 0;           // of tiles: whose content others replace
  bool on_earth = false;             // earth-centred coordinates
};

// `format`: as above, or "auto". `open` gives the bytes of a file by its path: of `path` itself,
// and of those that it names, which are sought beside it. Throws InputError.
ModelSource read_model(const std::string& path, const std::string& format, const ModelFiles& open);

}  // namespace geom
