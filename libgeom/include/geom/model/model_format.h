#pragma once

// The formats that models of triangles come in, as a table of their readers.
//
// Example:
//   const geom::ModelFormat& format = geom::model_format_of("v 0 0 0\n", "house.obj");
//   assert(format.format->word == "obj");

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "geom/base/format.h"
#include "geom/model/draco_mesh.h"
#include "geom/model/model.h"

namespace geom {

// Throws InputError(source, …).
using ReadScene = std::function<Model(const std::string& bytes, const std::string& source)>;

// What needs further libraries (skyway::geom_mesh has all of it).
struct ModelDecoders {
  DracoDecoder draco;
  ReadScene collada;
  ReadScene studio;  // 3DS
};

// A file, and how others beside it are opened.
struct ModelFile {
  const std::string& bytes;
  const std::string& path;  // for messages
  const std::string& name;  // without folders, by which `files` gives it, too
  const ModelFiles& files;
  const ModelDecoders& decoders;
};

struct LoadedModel {
  Model model;
  std::optional<std::size_t> tiles = {};  // of tiles: whose content was read
  std::size_t coarser = 0;                // of tiles: whose content others replace
  bool on_earth = false;                  // earth-centred coordinates
};

struct ModelFormat {
  const Format* format;
  Formats kinds = {};
  std::string_view ending = {};  // of names, in lower case, where no beginning tells the format
  // Where no format of the table is sure. Throws InputError(path, …) for JSON that is malformed.
  bool (*may_be)(std::string_view bytes, const std::string& path) = nullptr;
  LoadedModel (*read)(const ModelFile& file);  // throws InputError
};

// OBJ, PLY, STL, 3D Tiles, glTF, COLLADA and 3DS.
FormatRows<ModelFormat> model_formats();

// The format whose ending the name has, in any case of letters; null where there is none.
const ModelFormat* model_format_by_ending(const std::string& path);

// The format of a file of this content and name. Throws InputError where it looks like none.
const ModelFormat& model_format_of(std::string_view bytes, const std::string& path);

extern const ModelFormat kObjModel;
extern const ModelFormat kPlyModel;
extern const ModelFormat kStlModel;
extern const ModelFormat kTilesModel;
extern const ModelFormat kGltfModel;
extern const ModelFormat kColladaModel;
extern const ModelFormat k3dsModel;

extern const Format kGlbFile;   // binary glTF, of triangles or of lines
extern const Format kTileFile;  // b3dm: one tile, which tells no place

}  // namespace geom
