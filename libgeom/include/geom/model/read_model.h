#pragma once

// Reads a model of triangles in any of the formats, with the files that it names.
//
//   const geom::ModelSource house = geom::read_model("house.obj", nullptr, bytes_of_file);

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
