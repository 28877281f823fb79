#pragma once

// Reads a model of triangles in any of the formats, with the files that it names.
//
// Example:
//   const auto open = [](const std::string& path) {
//     std::ifstream file(path, std::ios::binary);
//     return std::string(std::istreambuf_iterator<char>(file), {});
//   };
//   const geom::ModelSource source = geom::read_model("house.obj", nullptr, open);
//   assert(source.format->format->word == "obj");

#include <cstddef>
#include <string>

#include "geom/model/model_format.h"
#include "geom/model/place_model.h"

namespace geom {

struct ModelSource : LoadedModel {
  const ModelFormat* format = nullptr;
  std::string hash;       // "sha256:…" of the file and of all that it names
  std::size_t files = 1;  // how many these are
};

// Without a `format`, what the file looks like (model_format_of). `open` gives the bytes of a file
// by its path: of `path` itself, and of those that it names, which are sought beside it. Throws
// InputError.
ModelSource read_model(const std::string& path, const ModelFormat* format, const ModelFiles& open);

}  // namespace geom
